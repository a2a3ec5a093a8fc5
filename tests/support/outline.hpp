// SPDX-License-Identifier: MIT
//
// Convex polygons and circles in the field's frame, their distances and contact points. This is the
// tests' own geometry: plain distances between corners and edges, no code of core/simulator.
#pragma once

#include "core/base/vec2.hpp"
#include "core/field/field.hpp"

#include <vector>

namespace mirocup::test_support {

// A convex polygon, counter-clockwise; with a single corner and a radius, a circle.
struct Outline {
  std::vector<Vec2> corners;
  double radius = 0.0;
};

Outline square_at(const Vec2& centre, double angle, double side);
Outline circle_at(const Vec2& centre, double radius);

// Returns everything solid around a field as large boxes: side walls, goal backs, cut corners,
// end walls.
std::vector<Outline> solids_around(const field::Field& field);

// Returns the Euclidean distance; minus the depth where they overlap. Not for two circles.
double distance(const Outline& a, const Outline& b);

struct TouchPoint {
  Vec2 point;
  Vec2 normal;  // unit, from b to a
  double gap;   // m
};

// Returns the points where the two are no farther apart than `margin`: both ends of what lies
// flush, else one, or none.
std::vector<TouchPoint> touch_points(const Outline& a, const Outline& b, double margin);

}  // namespace mirocup::test_support
