// SPDX-License-Identifier: MIT
//
// Gaps and contact points of outlines at one instant.
#pragma once

#include "core/field/field.hpp"
#include "core/simulator/segment.hpp"
#include "core/simulator/shape.hpp"

#include <array>

namespace mirocup::simulator {

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

// Two outlines and the line that separates them best, in the field's frame.
struct Separation {
  double gap;               // m, along the normal
  Vec2 normal{0.0, 0.0};    // unit, from b to a
  double reach_a, reach_b;  // m, of each from its reference point towards the other
};

// Of two polygons or a circle (first) and a polygon. The gap is the Euclidean distance where a
// corner or a circle faces an edge, a lower bound of it between two corners; minus the depth where
// they overlap.
Separation separation(const Shape& a, const Body& body_a, const Shape& b, const Body& body_b);
Separation separation(const Shape& a, const Body& body_a, const field::Wall& wall);

inline double gap(const Shape& a, const Body& body_a, const Shape& b, const Body& body_b) {
  return separation(a, body_a, b, body_b).gap;
}
inline double gap(const Shape& a, const Body& body_a, const field::Wall& wall) {
  return separation(a, body_a, wall).gap;
}

// The contact points whose gap is at most `margin`: two where edges lie flush, else one, or none.
ContactPoints contact_points(const Shape& a, const Body& body_a, const Shape& b, const Body& body_b,
                             double margin);
ContactPoints contact_points(const Shape& a, const Body& body_a, const field::Wall& wall,
                             double margin);

// The direction in which a polygon is separated best from a point, in the polygon's frame: an
// edge's normal, or away from a corner if the point is nearest to that.
struct Axis {
  Vec2 normal;
  double offset;  // of the polygon along the normal
  double separation;
  int edge;    // whose normal it is, or that faces the point
  int corner;  // the nearest corner if that is nearer than any edge, else -1
};
Axis nearest_axis(const Shape& polygon, const Vec2& point);

// The edge of `reference` along which it is separated best from the corners of `other`; the pose of
// `other` is given in the frame of `reference`.
struct EdgeSeparation {
  int edge;
  double separation;
};
EdgeSeparation best_edge(const Shape& reference, const Shape& other, const Vec2& position,
                         const Heading& heading);

// Which of two polygons offers the better separating edge. On a tie the first, whatever the poses. Of
// two that are more than `margin` m apart, an edge that says so.
struct Reference {
  bool is_a;
  EdgeSeparation best;
};
Reference reference_of(const Shape& a, const Body& body_a, const Shape& b, const Body& body_b,
                       double margin = infinity);

// Of two polygons, by the line of that edge, whichever separates them best now: how far the nearest
// corner of the other one is beyond it, m, and as contact points the two corners that face it.
double separation_from(const Reference& reference, const Shape& a, const Body& body_a,
                       const Shape& b, const Body& body_b);
ContactPoints corners_over(const Reference& reference, const Shape& a, const Body& body_a,
                           const Shape& b, const Body& body_b);

}  // namespace mirocup::simulator
