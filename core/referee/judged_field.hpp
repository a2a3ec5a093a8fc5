// SPDX-License-Identifier: MIT
//
// The pitch that a leg is judged on: the field, the rules, and the sizes of ball and robots.
#pragma once

#include "core/field/field.hpp"
#include "core/referee/rules.hpp"

namespace mirocup::referee {

// Lengths in metres. Field and rules belong to the caller and outlive the pitch.
struct JudgedField {
  const field::Field& field;
  const Rules& rules;
  double ball_radius = 0.0;
  double robot_side = 0.0;  // robots are squares
};

// A quarter of the field, as the signs of x and y in it: each is 1 or -1.
struct Quarter {
  double x = 1.0;
  double y = 1.0;
};

// Returns the quarter of a point. A coordinate of 0 counts as negative.
Quarter quarter_of(const Vec2& point);

}  // namespace mirocup::referee
