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
  std::array<std::string, 2> goals;  // the floor of each goal, indexed by index_of(End)
  std::string lines;                 // path of lines and circles
  // Goal area and penalty area of each end (index_of(End)), without arcs.
  std::array<std::string, 2> zones;
  std::string spots;  // centre, penalty and free-ball marks, as filled discs
};

Markings markings(const field::Field& field);

}  // namespace mirocup::web
