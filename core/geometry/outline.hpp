// SPDX-License-Identifier: MIT
//
// Outlines: a circle, or a convex polygon, given in the body's own frame around its reference
// point.
#pragma once

#include "core/base/math.hpp"
#include "core/base/vec2.hpp"
#include "core/field/field.hpp"

#include <array>
#include <span>

namespace mirocup::geometry {

// A convex polygon in the robot's frame, counter-clockwise around its centre of mass, m. The wheels'
// axis goes through the centre of mass.
inline constexpr int max_corners = 8;
struct OutlineCorners {
  int corners = 0;  // at least 3, or 0: none is given
  std::array<double, max_corners> x{}, y{};

  Vec2 corner(int i) const { return {x[i], y[i]}; }
};

struct Outline {
  int corners = 0;  // 0: a circle
  double radius =
      0.0;  // of the circle, or of the smallest circle around the reference point that holds all

  // Of the largest circle around the reference point within a polygon; -infinity if that point is
  // outside.
  double inner_radius = -infinity;

  // Counter-clockwise. Edge i runs from corner i to corner i + 1; normal . x = offset on it,
  // outwards.
  std::array<Vec2, max_corners> corner;
  std::array<Vec2, max_corners> normal;
  std::array<double, max_corners> offset;

  bool is_circle() const { return corners == 0; }
  int next(int i) const { return i + 1 == corners ? 0 : i + 1; }
};

Outline circle(double radius);

// A square of that side, centred; edge 0 is its front (+x).
Outline square(double side);

// A convex polygon from its corners, counter-clockwise, at least 3.
Outline polygon(std::span<const Vec2> corners);

// The solid end wall behind a goal post, in the field's frame. It reaches far outside, where
// nothing is.
Outline end_wall(const field::GoalPost& post);

}  // namespace mirocup::geometry
