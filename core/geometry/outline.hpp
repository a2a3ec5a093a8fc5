// SPDX-License-Identifier: MIT
//
// Outlines: a circle, or a convex polygon, in the body's own frame around its reference point.
//
// Lengths are in metres. The room geometry uses base and field; it knows poses but no simulated
// world, so the referee may use it.
#pragma once

#include "core/base/math.hpp"
#include "core/base/vec2.hpp"
#include "core/field/field.hpp"

#include <array>
#include <span>

namespace mirocup::geometry {

// The largest number of corners of a polygon.
inline constexpr int max_corners = 8;

// A convex polygon in the robot's frame, counter-clockwise around its centre of mass, m. The axis
// of the wheels goes through the centre of mass.
struct OutlineCorners {
  int corners = 0;  // 0 (no polygon), or 3 to max_corners
  std::array<double, max_corners> x{}, y{};

  Vec2 corner(int i) const { return {x[i], y[i]}; }
};

// The outline of a body or an obstacle, with the numbers of each edge that queries need. A plain
// value; make one with the functions below.
struct Outline {
  int corners = 0;  // 0: a circle

  // m: radius of the circle, or of the smallest circle around the reference point that holds the
  // polygon.
  double radius = 0.0;

  // m: radius of the largest circle around the reference point that is inside the polygon;
  // -infinity for a circle, and if the reference point is not inside the polygon.
  double inner_radius = -infinity;

  // Counter-clockwise. Edge i runs from corner i to corner next(i). Its unit normal points
  // outwards, and normal . x = offset on the edge.
  std::array<Vec2, max_corners> corner;
  std::array<Vec2, max_corners> normal;
  std::array<double, max_corners> offset;

  bool is_circle() const { return corners == 0; }
  // Returns the index of the corner after corner i.
  int next(int i) const { return i + 1 == corners ? 0 : i + 1; }
};

// Returns a circle around the reference point.
Outline circle(double radius);

// Returns a square with its centre at the reference point. Edge 0 is its front (+x).
Outline square(double side);

// Returns a polygon. Precondition: 3 to max_corners corners, convex, counter-clockwise.
Outline polygon(std::span<const Vec2> corners);

// Returns the solid end wall behind a goal post, in the field's frame. It extends 10 m from the
// post, away from the field and from the goal mouth, beyond all bodies.
Outline end_wall(const field::GoalPost& post);

}  // namespace mirocup::geometry
