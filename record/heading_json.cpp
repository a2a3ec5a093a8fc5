// SPDX-License-Identifier: MIT
#include "record/heading_json.hpp"

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

}  // namespace mirocup::record
