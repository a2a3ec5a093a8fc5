// SPDX-License-Identifier: MIT
//
// Gaps of outlines at one instant, by the separating axis theorem (Gottschalk, Lin, Manocha 1996):
// two convex outlines do not overlap if there is a line between them. In this file, the separating
// axis is the normal of the line that leaves the largest gap.
//
// All functions are pure. Lengths are in metres, poses in the field's frame.
#pragma once

#include "core/field/field.hpp"
#include "core/field/frames.hpp"
#include "core/geometry/outline.hpp"

namespace mirocup::geometry {

// An edge of a polygon, and how far outside its line the nearest corner of another polygon is.
struct EdgeSeparation {
  int edge;
  double separation;  // m, negative if that corner is inside of the line
};

// The reference edge of two polygons: of all edges of both, the one that separates them best.
struct Reference {
  bool is_a;  // the edge belongs to a
  EdgeSeparation best;
};

// The best separating line of outlines a and b, in the field's frame.
struct Separation {
  double gap;               // m, along the normal; negative where the outlines overlap
  Vec2 normal{0.0, 0.0};    // unit vector from b to a
  double reach_a, reach_b;  // m: extent of a and of b from its reference point towards the other
  Reference reference{};    // only of two polygons
};

// Return the separation of two polygons, or of a circle (a) and a polygon (b); or of an outline and
// a wall. The gap is the Euclidean distance where a corner or a circle faces an edge, and a lower
// bound of it between two corners. If the outlines overlap, it is minus the overlap's depth.
Separation separation(const Outline& a, const Pose& body_a, const Outline& b, const Pose& body_b);
Separation separation(const Outline& a, const Pose& body_a, const field::Wall& wall);

// Return the gap alone, m.
inline double gap(const Outline& a, const Pose& body_a, const Outline& b, const Pose& body_b) {
  return separation(a, body_a, b, body_b).gap;
}
inline double gap(const Outline& a, const Pose& body_a, const field::Wall& wall) {
  return separation(a, body_a, wall).gap;
}

// The direction in which a polygon is separated best from a point, in the polygon's frame.
struct Axis {
  Vec2 normal;        // unit: an edge's normal, or from the nearest corner to the point
  double offset;      // m: extent of the polygon from its reference point along the normal
  double separation;  // m: distance of the point from the polygon, negative inside
  int edge;           // the edge that faces the point
  int corner;         // the nearest corner if it is nearer than any edge, else -1
};
// Returns the axis of a polygon and a point, both in the polygon's frame.
Axis nearest_axis(const Outline& polygon, const Vec2& point);
// Returns the axis of polygon b and the reference point of body a, in the frame of b.
Axis axis_to_centre(const Pose& body_a, const Outline& b, const Pose& body_b);

// Returns the edge of `reference` that separates it best from `other`, whose pose is given in the
// frame of `reference`.
EdgeSeparation best_edge(const Outline& reference, const Outline& other, const Vec2& position,
                         const Heading& heading);

// Returns the reference edge. On a tie it is an edge of `a`, whatever the poses, so that a
// half-turn of the field changes nothing. If an edge of `a` separates the two by more than
// `margin`, m, that edge is returned, and the edges of b are not tried.
Reference reference_of(const Outline& a, const Pose& body_a, const Outline& b, const Pose& body_b,
                       double margin = infinity);

// Returns how far, m, the other polygon's nearest corner is outside the line of the given reference
// edge (negative: inside), whether or not that edge separates the two best at these poses.
double separation_from(const Reference& reference, const Outline& a, const Pose& body_a,
                       const Outline& b, const Pose& body_b);

}  // namespace mirocup::geometry
