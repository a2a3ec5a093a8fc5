// SPDX-License-Identifier: MIT
//
// Scenes and their results as JSON: schemas mirocup/scene/1 and mirocup/scene-result/1, which
// scene.md describes.
#pragma once

#include "core/base/error.hpp"
#include "core/simulator/scene.hpp"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <string_view>

namespace mirocup::record {

// Reads a scene and checks that no bodies overlap or lie outside the field. The error, Errc::input,
// names the file `path`, the JSON pointer and the reason.
Result<simulator::Scene> parse_scene(std::string_view text, const std::string& path);

// Returns the result of a scene. `cpu_seconds` is the processor time of the simulation.
nlohmann::ordered_json to_json(const simulator::Scene& scene, const simulator::SceneResult& result,
                               double cpu_seconds);

}  // namespace mirocup::record
