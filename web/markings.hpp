// SPDX-License-Identifier: MIT
//
// The outline of a field and its markings as SVG path data, for pictures, replay pages and live
// pages.
#pragma once

#include "core/field/field.hpp"

#include <array>
#include <string>

namespace mirocup::web {

struct Markings {
  std::string ground;                // the outline of the floor with cut corners and goals
  std::array<std::string, 2> goals;  // [index_of(End)]: the floor of the goal
  std::string lines;                 // lines and circles
  std::array<std::string, 2> zones;  // [index_of(End)]: goal area and penalty area, without arcs
  std::string spots;                 // centre, penalty and free-ball marks, as filled discs
};

Markings markings(const field::Field& field);

}  // namespace mirocup::web
