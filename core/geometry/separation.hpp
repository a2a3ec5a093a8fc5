// SPDX-License-Identifier: MIT
//
// Gaps of outlines at one instant: the line that separates two of them best.
#pragma once

#include "core/field/field.hpp"
#include "core/field/frames.hpp"
#include "core/geometry/outline.hpp"

namespace mirocup::geometry {

// Two outlines and the line that separates them best, in the field's frame.
struct Separation {
  double gap;               // m, along the normal
  Vec2 normal{0.0, 0.0};    // unit, from b to a
  double reach_a, reach_b;  // m, of each from its reference point towards the other
};

// Of two polygons or a circle (first) and a polygon. The gap is the Euclidean distance where a
// corner or a circle faces an edge, a lower bound of it between two corners; minus the depth where
// they overlap.
Separation separation(const Outline& a, const Pose& body_a, const Outline& b, const Pose& body_b);
Separation separation(const Outline& a, const Pose& body_a, const field::Wall& wall);

inline double gap(const Outline& a, const Pose& body_a, const Outline& b, const Pose& body_b) {
  return separation(a, body_a, b, body_b).gap;
}
inline double gap(const Outline& a, const Pose& body_a, const field::Wall& wall) {
  return separation(a, body_a, wall).gap;
}

// The direction in which a polygon is separated best from a point, in the polygon's frame: an
// edge's normal, or away from a corner if the point is nearest to that.
struct Axis {
  Vec2 normal;
  double offset;  // of the polygon along the normal
  double separation;
  int edge;    // whose normal it is, or that faces the point
  int corner;  // the nearest corner if that is nearer than any edge, else -1
};
Axis nearest_axis(const Outline& polygon, const Vec2& point);
// The same for the reference point of another body, in the frame of polygon b.
Axis axis_to_centre(const Pose& body_a, const Outline& b, const Pose& body_b);

// The edge of `reference` along which it is separated best from the corners of `other`; the pose of
// `other` is given in the frame of `reference`.
struct EdgeSeparation {
  int edge;
  double separation;
};
EdgeSeparation best_edge(const Outline& reference, const Outline& other, const Vec2& position,
                         const Heading& heading);

// Which of two polygons offers the better separating edge. On a tie the first, whatever the poses. Of
// two that are more than `margin` m apart, an edge that says so.
struct Reference {
  bool is_a;
  EdgeSeparation best;
};
Reference reference_of(const Outline& a, const Pose& body_a, const Outline& b, const Pose& body_b,
                       double margin = infinity);

// Of two polygons, by the line of that edge, whichever separates them best now: how far the nearest
// corner of the other one is beyond it, m.
double separation_from(const Reference& reference, const Outline& a, const Pose& body_a,
                       const Outline& b, const Pose& body_b);

}  // namespace mirocup::geometry
