// SPDX-License-Identifier: MIT
//
// Scenes and their results as JSON: schemas mirocup/scene/1 and mirocup/scene-result/1, described in
// scene.md. Exceptions of the JSON library end here.
#pragma once

#include "core/base/error.hpp"
#include "core/simulator/scene.hpp"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <string_view>

namespace mirocup::record {

// Reads a scene and checks it: nothing overlaps, nothing lies outside the field. `path` is for the
// error message, which names the file, the JSON pointer and the reason; the error is Errc::input.
Result<simulator::Scene> parse_scene(std::string_view text, const std::string& path);

// `cpu_seconds`: what the run took.
nlohmann::ordered_json to_json(const simulator::Scene& scene, const simulator::SceneResult& result,
                               double cpu_seconds);

}  // namespace mirocup::record
