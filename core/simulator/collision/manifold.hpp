// SPDX-License-Identifier: MIT
//
// Where two outlines touch or nearly touch at one instant.
#pragma once

#include "core/field/field.hpp"
#include "core/geometry/outline.hpp"
#include "core/geometry/separation.hpp"

#include <array>

namespace mirocup::simulator::collision {

// What rests on what. Of two polygons one has an edge and the other a corner on it; the ball rests
// on an edge or on a corner. The one with the point (corner or ball) is called the point's side,
// the other the edge's side.
enum class Touching { corner_on_edge, circle_on_edge, circle_on_corner };

// A place where a and b touch or nearly touch, in the field's frame.
struct ContactPoint {
  Vec2 point{0.0, 0.0};
  Vec2 normal{0.0, 0.0};  // unit, from the edge's side to the point's side
  double gap = 0.0;       // m, negative inside
  Touching kind = Touching::corner_on_edge;
  bool point_on_a = true;
  int corner = 0;  // of the point's side, or of the edge's side for circle_on_corner
  int edge = 0;    // of the edge's side
};

struct ContactPoints {
  std::array<ContactPoint, 2> points;
  int count = 0;

  void add(const ContactPoint& p) { points[count++] = p; }
};

// The contact points whose gap is at most `margin`: two where edges lie flush, else one, or none.
ContactPoints contact_points(const geometry::Outline& a, const Pose& body_a,
                             const geometry::Outline& b, const Pose& body_b, double margin);
ContactPoints contact_points(const geometry::Outline& a, const Pose& body_a,
                             const field::Wall& wall, double margin);

// Of two polygons, by the line of that edge, whichever separates them best now: as contact points the
// two corners of the other one that face it.
ContactPoints corners_over(const geometry::Reference& reference, const geometry::Outline& a,
                           const Pose& body_a, const geometry::Outline& b, const Pose& body_b);

}  // namespace mirocup::simulator::collision
