// SPDX-License-Identifier: MIT
//
// Vectors, twists and headings as JSON. A heading is an angle in radians, or its exact cosine and
// sine.
#pragma once

#include "core/base/heading.hpp"
#include "core/simulator/model/state.hpp"

#include <nlohmann/json_fwd.hpp>

namespace mirocup::record {

class JsonReader;

// Complains about an angle beyond +-max_angle, rad, and about a pair [cos, sin] that is not of
// length 1 within 1e-12. A pair is not normalized, because normalizing would change its last bits.
Heading read_heading(const JsonReader& json, double max_angle);

// Returns [x, y], with each value within +-max; zero after a complaint about another form.
Vec2 read_vector(const JsonReader& json, double max);
nlohmann::ordered_json vector_json(const Vec2& vector);

// Returns [forward, left, omega], with speeds within +-max_speed, m/s, and a turn within
// +-max_turn, rad/s; zero after a complaint about another form.
simulator::Twist read_twist(const JsonReader& json, double max_speed, double max_turn);

}  // namespace mirocup::record
