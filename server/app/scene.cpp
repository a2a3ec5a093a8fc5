// SPDX-License-Identifier: MIT
//
// mirocup scene FILE: simulates bodies and wheel commands, without teams and laws.
#include "server/app/commands.hpp"
#include "server/record/scene_json.hpp"
#include "server/system/files.hpp"

#include <nlohmann/json.hpp>

#include <ctime>
#include <iostream>

namespace mirocup::app {

Result<int> run_scene(const SceneOptions& options) {
  system::Disk disk;
  const auto text = disk.read(options.path);
  if (!text) return tl::unexpected(text.error());
  const auto scene = record::parse_scene(*text, options.path);
  if (!scene) return tl::unexpected(scene.error());

  const auto accuracy = *from_string<simulator::Accuracy>(options.accuracy);
  const std::clock_t begin = std::clock();
  const auto result = simulator::run_scene(*scene, simulator::tolerances_of(accuracy));
  const double cpu_seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;

  const std::string json = record::to_json(*scene, result, cpu_seconds).dump() + "\n";
  if (options.out.empty()) {
    std::cout << json;
  } else if (auto written = disk.write(options.out, json); !written) {
    return tl::unexpected(written.error());
  }
  return exit_yes;
}

}  // namespace mirocup::app
