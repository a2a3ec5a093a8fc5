// SPDX-License-Identifier: MIT
//
// Reads any bytes as a scene. A short one is also run: what a scene may ask for must end.
#include "record/json_reader.hpp"
#include "record/scene_json.hpp"
#include "tests/security/fuzz/fuzz_target.hpp"

MIROCUP_FUZZ_TARGET(scene) {
  using namespace mirocup;
  const auto scene = record::parse_scene(mirocup::fuzz::text_of(data, size), "scene.json");
  constexpr double longest = 0.2;  // s
  constexpr std::size_t most_robots = 4;
  constexpr std::size_t most_samples = 100;
  if (!scene || scene->duration > longest || scene->robots.size() > most_robots ||
      scene->sample_at.size() > most_samples) {
    return;
  }
  const auto result = simulator::run_scene(*scene, simulator::Tolerances{});
  (void)record::json_text(record::to_json(*scene, result, 0.0));
}
