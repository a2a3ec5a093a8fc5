// SPDX-License-Identifier: MIT
#include "record/motion_json.hpp"

#include "record/json_reader.hpp"

#include <cmath>

namespace mirocup::record {

namespace {

// How far the length of a heading [cos, sin] may be from 1.
constexpr double max_heading_length_error = 1e-12;

}  // namespace

Heading read_heading(const JsonReader& json, double max_angle) {
  if (!json.json().is_array()) return Heading::from_angle(json.number(-max_angle, max_angle));
  if (!json.expect_array(2, 2)) return {};
  const Heading heading{json.at(0).number(), json.at(1).number()};
  const double length = std::sqrt(heading.cos * heading.cos + heading.sin * heading.sin);
  if (!(std::abs(length - 1.0) <= max_heading_length_error)) {
    json.complain("a heading [cos, sin] must be of length 1 within 1e-12");
    return {};
  }
  return heading;
}

Vec2 read_vector(const JsonReader& json, double max) {
  if (!json.expect_array(2, 2)) return {0.0, 0.0};
  return {json.at(0).number(-max, max), json.at(1).number(-max, max)};
}

nlohmann::ordered_json vector_json(const Vec2& vector) {
  return nlohmann::ordered_json::array({vector.x(), vector.y()});
}

simulator::Twist read_twist(const JsonReader& json, double max_speed, double max_turn) {
  if (!json.expect_array(3, 3)) return {};
  return {json.at(0).number(-max_speed, max_speed), json.at(1).number(-max_speed, max_speed),
          json.at(2).number(-max_turn, max_turn)};
}

}  // namespace mirocup::record
