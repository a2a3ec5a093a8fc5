// SPDX-License-Identifier: MIT
#include "core/geometry/separation.hpp"

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace mirocup::geometry {

namespace {

// Returns the pose of `body` in the frame of `of`.
Pose relative(const Pose& body, const Pose& of) {
  return {of.heading.to_body(body.position - of.position), body.heading.seen_from(of.heading)};
}

// Returns f(corners of the polygon), a compile-time constant for the usual four: loops unroll then.
template <class F>
auto with_corners(const Outline& polygon, F f) {
  return polygon.corners == 4 ? f(std::integral_constant<int, 4>{}) : f(polygon.corners);
}

// The smallest normal . corner, m; `normal` is in the polygon's frame.
double nearest_corner(const Outline& polygon, const Vec2& normal) {
  return with_corners(polygon, [&](auto corners) {
    double nearest = infinity;
    for (int i = 0; i < corners; ++i) nearest = std::min(nearest, normal.dot(polygon.corner[i]));
    return nearest;
  });
}

}  // namespace

Axis nearest_axis(const Outline& polygon, const Vec2& point) {
  int edge = 0;
  double best = -infinity;
  for (int i = 0; i < polygon.corners; ++i) {
    const double d = polygon.normal[i].dot(point) - polygon.offset[i];
    if (d > best) {
      best = d;
      edge = i;
    }
  }
  const Axis facing{polygon.normal[edge], polygon.offset[edge], best, edge, -1};
  if (best <= 0.0) return facing;

  const Vec2& start = polygon.corner[edge];
  const Vec2& stop = polygon.corner[polygon.next(edge)];
  const Vec2 along = stop - start;
  int corner = -1;
  if (along.dot(point - start) < 0.0) corner = edge;
  if (along.dot(point - stop) > 0.0) corner = polygon.next(edge);
  if (corner < 0) return facing;
  const Vec2 away = point - polygon.corner[corner];
  const double distance = std::sqrt(away.squaredNorm());
  const Vec2 normal = away / distance;
  return {normal, normal.dot(polygon.corner[corner]), distance, edge, corner};
}

Axis axis_to_centre(const Pose& body_a, const Outline& b, const Pose& body_b) {
  return nearest_axis(b, body_b.heading.to_body(body_a.position - body_b.position));
}

// The edge that faces the other's reference point comes first. Another edge can only be better if
// even the other's inner circle leaves room for that, which rules most edges out.
EdgeSeparation best_edge(const Outline& reference, const Outline& other, const Vec2& position,
                         const Heading& heading) {
  return with_corners(reference, [&](auto corners) {
    std::array<double, max_corners> centre_distance{};
    int facing = 0;
    for (int edge = 0; edge < corners; ++edge) {
      centre_distance[edge] = reference.normal[edge].dot(position) - reference.offset[edge];
      if (centre_distance[edge] > centre_distance[facing]) facing = edge;
    }
    const auto separation_of = [&](int edge) {
      return centre_distance[edge] + nearest_corner(other, heading.to_body(reference.normal[edge]));
    };
    EdgeSeparation best{facing, separation_of(facing)};
    const double reach = other.inner_radius * (1.0 - 1e-9);  // less a share for rounding
    for (int edge = 0; edge < corners; ++edge) {
      if (edge == facing || centre_distance[edge] - reach <= best.separation) continue;
      const double separation = separation_of(edge);
      if (separation > best.separation) best = {edge, separation};
    }
    return best;
  });
}

Reference reference_of(const Outline& a, const Pose& body_a, const Outline& b, const Pose& body_b,
                       double margin) {
  const Pose b_in_a = relative(body_b, body_a);
  const EdgeSeparation of_a = best_edge(a, b, b_in_a.position, b_in_a.heading);
  if (of_a.separation > margin) return {true, of_a};
  const Pose a_in_b = relative(body_a, body_b);
  const EdgeSeparation of_b = best_edge(b, a, a_in_b.position, a_in_b.heading);
  if (of_a.separation >= of_b.separation) return {true, of_a};
  return {false, of_b};
}

double separation_from(const Reference& reference, const Outline& a, const Pose& body_a,
                       const Outline& b, const Pose& body_b) {
  const int edge = reference.best.edge;
  const Outline& side = reference.is_a ? a : b;
  const Pose other = reference.is_a ? relative(body_b, body_a) : relative(body_a, body_b);
  return side.normal[edge].dot(other.position) - side.offset[edge] +
         nearest_corner(reference.is_a ? b : a, other.heading.to_body(side.normal[edge]));
}

Separation separation(const Outline& a, const Pose& body_a, const Outline& b, const Pose& body_b) {
  if (a.is_circle()) {
    const Axis axis = axis_to_centre(body_a, b, body_b);
    return {axis.separation - a.radius, body_b.heading.to_world(axis.normal), a.radius,
            axis.offset};
  }
  const Reference reference = reference_of(a, body_a, b, body_b);
  const double gap = reference.best.separation;
  const Outline& side = reference.is_a ? a : b;
  const Heading& heading = reference.is_a ? body_a.heading : body_b.heading;
  const Vec2 outwards = heading.to_world(side.normal[reference.best.edge]);
  const Vec2 normal = reference.is_a ? Vec2{-outwards} : outwards;
  const double own_reach = side.offset[reference.best.edge];
  const double other_reach = normal.dot(body_a.position - body_b.position) - own_reach - gap;
  return reference.is_a ? Separation{gap, normal, own_reach, other_reach, reference}
                        : Separation{gap, normal, other_reach, own_reach, reference};
}

Separation separation(const Outline& a, const Pose& body_a, const field::Wall& wall) {
  double reach = a.radius;
  if (!a.is_circle()) reach = -nearest_corner(a, body_a.heading.to_body(wall.normal));
  return {wall.normal.dot(body_a.position) - wall.offset - reach, wall.normal, reach, 0.0};
}

}  // namespace mirocup::geometry
