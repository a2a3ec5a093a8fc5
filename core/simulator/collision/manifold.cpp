// SPDX-License-Identifier: MIT
#include "core/simulator/collision/manifold.hpp"

#include <algorithm>

namespace mirocup::simulator::collision {

namespace {

// The edge of `other` that faces against `normal` most, both in the field's frame.
int incident_edge(const geometry::Outline& other, const Pose& body, const Vec2& normal) {
  const Vec2 n = body.heading.to_body(normal);
  int best = 0;
  double most_against = infinity;
  for (int i = 0; i < other.corners; ++i) {
    const double d = n.dot(other.normal[i]);
    if (d < most_against) {
      most_against = d;
      best = i;
    }
  }
  return best;
}

// Where an edge of `reference` and the edge of `other` that faces it lie over each other: the ends
// of the common part. Each end is a corner of one side over the edge of the other.
ContactPoints over_edge(const geometry::Outline& reference, const Pose& body, int edge,
                        const geometry::Outline& other, const Pose& other_body, bool other_is_a,
                        double margin) {
  const Vec2 start = body.position + body.heading.to_world(reference.corner[edge]);
  const Vec2 stop = body.position + body.heading.to_world(reference.corner[reference.next(edge)]);
  const Vec2 normal = body.heading.to_world(reference.normal[edge]);
  const Vec2 along = stop - start;
  const double length =
      along.squaredNorm();  // times itself: positions along the edge go from 0 to this

  const int facing = incident_edge(other, other_body, normal);
  const std::array<int, 2> corners{facing, other.next(facing)};
  std::array<Vec2, 2> end;
  std::array<double, 2> at;
  for (int i = 0; i < 2; ++i) {
    end[i] = other_body.position + other_body.heading.to_world(other.corner[corners[i]]);
    at[i] = along.dot(end[i] - start);
  }

  ContactPoints found;
  const auto add_corner_of_other = [&](int i) {
    const double d = normal.dot(end[i] - start);
    if (d > margin) return;
    found.add({end[i], normal, d, Touching::corner_on_edge, other_is_a, corners[i], edge});
  };
  if ((at[0] < 0.0 && at[1] < 0.0) || (at[0] > length && at[1] > length)) {
    // Corner beside corner: the nearer end stands for the contact.
    add_corner_of_other(normal.dot(end[0] - start) <= normal.dot(end[1] - start) ? 0 : 1);
    return found;
  }
  const Vec2 facing_normal = other_body.heading.to_world(other.normal[facing]);
  for (int i = 0; i < 2; ++i) {
    if (at[i] >= 0.0 && at[i] <= length) {
      add_corner_of_other(i);
      continue;
    }
    // This end stands out over the reference edge: there the reference's own corner is on the
    // facing edge.
    const bool first = at[i] < 0.0;
    const Vec2& corner = first ? start : stop;
    const double d = facing_normal.dot(corner - end[0]);
    if (d > margin) continue;
    found.add({corner, facing_normal, d, Touching::corner_on_edge, !other_is_a,
               first ? edge : reference.next(edge), facing});
  }
  return found;
}

}  // namespace

ContactPoints corners_over(const geometry::Reference& reference, const geometry::Outline& a,
                           const Pose& body_a, const geometry::Outline& b, const Pose& body_b) {
  const int edge = reference.best.edge;
  const geometry::Outline& side = reference.is_a ? a : b;
  const Pose& body = reference.is_a ? body_a : body_b;
  const geometry::Outline& other = reference.is_a ? b : a;
  const Pose& other_body = reference.is_a ? body_b : body_a;
  const Vec2 start = body.position + body.heading.to_world(side.corner[edge]);
  const Vec2 normal = body.heading.to_world(side.normal[edge]);
  const int facing = incident_edge(other, other_body, normal);
  ContactPoints found;
  for (const int corner : {facing, other.next(facing)}) {
    const Vec2 place = other_body.position + other_body.heading.to_world(other.corner[corner]);
    found.add({place, normal, normal.dot(place - start), Touching::corner_on_edge, !reference.is_a,
               corner, edge});
  }
  return found;
}

ContactPoints contact_points(const geometry::Outline& a, const Pose& body_a,
                             const geometry::Outline& b, const Pose& body_b, double margin) {
  if (a.is_circle()) {
    ContactPoints found;
    const geometry::Axis axis = axis_to_centre(body_a, b, body_b);
    const double d = axis.separation - a.radius;
    if (d > margin) return found;
    const Vec2 normal = body_b.heading.to_world(axis.normal);
    found.add({body_a.position - a.radius * normal, normal, d,
               axis.corner < 0 ? Touching::circle_on_edge : Touching::circle_on_corner, true,
               axis.corner, axis.edge});
    return found;
  }
  const geometry::Reference reference = reference_of(a, body_a, b, body_b, margin);
  if (reference.best.separation > margin) return {};
  return reference.is_a ? over_edge(a, body_a, reference.best.edge, b, body_b, false, margin)
                        : over_edge(b, body_b, reference.best.edge, a, body_a, true, margin);
}

ContactPoints contact_points(const geometry::Outline& a, const Pose& body_a,
                             const field::Wall& wall, double margin) {
  ContactPoints found;
  if (a.is_circle()) {
    const double d = gap(a, body_a, wall);
    if (d > margin) return found;
    found.add({body_a.position - a.radius * wall.normal, wall.normal, d, Touching::circle_on_edge});
    return found;
  }
  for (int i = 0; i < a.corners && found.count < 2; ++i) {
    const Vec2 corner = body_a.position + body_a.heading.to_world(a.corner[i]);
    const double d = wall.normal.dot(corner) - wall.offset;
    if (d > margin) continue;
    found.add({corner, wall.normal, d, Touching::corner_on_edge, true, i});
  }
  return found;
}

}  // namespace mirocup::simulator::collision
