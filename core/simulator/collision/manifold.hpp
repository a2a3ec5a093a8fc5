// SPDX-License-Identifier: MIT
//
// Contact manifold: the one or two points at which two convex outlines touch or nearly touch at one
// instant. Polygons are clipped against each other as in Box2D: the edge with the largest
// separation is the reference edge, the edge of the other polygon that faces it is the incident
// edge, and the contact points are the ends of their common part.
//
// Units are m; points and normals are in the field's frame. Pure functions. Uses geometry only.
#pragma once

#include "core/base/assert.hpp"
#include "core/field/field.hpp"
#include "core/geometry/outline.hpp"
#include "core/geometry/separation.hpp"

#include <array>

namespace mirocup::simulator::collision {

// The features that touch. Of two polygons one has an edge and the other a corner on it; the ball
// touches an edge or a corner. The outline with the point (corner or ball) is called the point's
// side, the other one the edge's side.
enum class Touching { corner_on_edge, circle_on_edge, circle_on_corner };

// One point at which outlines a and b touch or nearly touch.
struct ContactPoint {
  Vec2 point{0.0, 0.0};   // m, on the point's side
  Vec2 normal{0.0, 0.0};  // unit, from the edge's side to the point's side
  double gap = 0.0;       // m, negative if the outlines overlap
  Touching kind = Touching::corner_on_edge;
  bool point_on_a = true;  // a is the point's side
  int corner = 0;          // index: of the point's side; for circle_on_corner, of the edge's side
  int edge = 0;            // index: of the edge's side; 0 for a plane wall
};

// The contact points of one pair of outlines.
struct ContactPoints {
  static constexpr int max_points = 2;
  std::array<ContactPoint, max_points> points;
  int count = 0;

  void add(const ContactPoint& p) {
    MIROCUP_ASSERT(count < max_points);
    points[count++] = p;
  }
};

// Returns the contact points with a gap of at most `margin`, m: two where an edge faces an edge,
// one at a corner or for a circle, none if the outlines are farther apart. If one is a circle, it
// is `a`.
ContactPoints contact_points(const geometry::Outline& a, const Pose& body_a,
                             const geometry::Outline& b, const Pose& body_b, double margin);
ContactPoints contact_points(const geometry::Outline& a, const Pose& body_a,
                             const field::Wall& wall, double margin);

// Returns both corners of the incident edge as contact points, with their gaps from the line of a
// given reference edge: whatever the gap, and unclipped. The reference need not be the best one at
// these poses.
ContactPoints incident_corners(const geometry::Reference& reference, const geometry::Outline& a,
                               const Pose& body_a, const geometry::Outline& b, const Pose& body_b);

}  // namespace mirocup::simulator::collision
