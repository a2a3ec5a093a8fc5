// SPDX-License-Identifier: MIT
//
// The parameters of the model as JSON, in scenes and in pitches. scene.md lists them.
#pragma once

#include "core/simulator/model/parameters.hpp"

#include <nlohmann/json_fwd.hpp>

namespace mirocup::record {

class JsonReader;

// Applies the keys of the object to `parameters`; other parameters stay unchanged. Complains about
// an unknown key, a wrong type and an impossible number. A number may also be {"value", "low",
// "high"}, as `mirocup identify` writes it; then only "value" counts.
void read_physics(const JsonReader& json, simulator::Parameters& parameters);

// Reads the corners of a convex polygon around [0, 0], m.
geometry::OutlineCorners read_outline(const JsonReader& json);

// Returns all parameters but the outline; the numbers of two-lag motors and of the brake only if
// the model has them.
nlohmann::ordered_json to_json(const simulator::Parameters& parameters);

// Returns the corners of the outline; an empty list for a square robot.
nlohmann::ordered_json outline_json(const simulator::Parameters& parameters);

}  // namespace mirocup::record
