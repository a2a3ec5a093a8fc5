// SPDX-License-Identifier: MIT
//
// What is painted on a playground, and its outline, as paths: the one geometry that still pictures,
// the replay page and the live page draw.
#pragma once

#include "core/field/field.hpp"

#include <array>
#include <string>

namespace mirocup::web {

struct Markings {
  std::string ground;                // the outline of the floor with cut corners and goals
  std::array<std::string, 2> goals;  // [index_of(End)]: the floor of the goal
  std::string lines;                 // lines and circles
  std::string spots;                 // centre, penalty and free-ball marks, as filled discs
};

Markings markings(const field::Field& field);

}  // namespace mirocup::web
