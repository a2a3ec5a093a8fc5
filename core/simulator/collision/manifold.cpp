// SPDX-License-Identifier: MIT
#include "core/simulator/collision/manifold.hpp"

namespace mirocup::simulator::collision {

namespace {

// A polygon at a pose in the field's frame.
struct PlacedPolygon {
  const geometry::Outline& shape;
  const Pose& pose;

  Vec2 corner(int i) const { return pose.position + pose.heading.to_world(shape.corner[i]); }
  Vec2 normal(int edge) const { return pose.heading.to_world(shape.normal[edge]); }
};

// Returns the edge whose normal is most opposed to `normal`, which is in the field's frame.
int incident_edge(const PlacedPolygon& polygon, const Vec2& normal) {
  const Vec2 n = polygon.pose.heading.to_body(normal);
  int best = 0;
  double most_opposed = infinity;
  for (int i = 0; i < polygon.shape.corners; ++i) {
    const double d = n.dot(polygon.shape.normal[i]);
    if (d < most_opposed) {
      most_opposed = d;
      best = i;
    }
  }
  return best;
}

// Clips the incident edge of `other` to an edge of `reference`: the contact points are the ends of
// the common part. Each end is a corner of one polygon over the edge of the other.
ContactPoints clip_to_edge(const PlacedPolygon& reference, int edge, const PlacedPolygon& other,
                           bool other_is_a, double margin) {
  const Vec2 start = reference.corner(edge);
  const Vec2 stop = reference.corner(reference.shape.next(edge));
  const Vec2 normal = reference.normal(edge);
  // Positions along the edge are scalar products with `along`: 0 at its start, its squared length
  // at its stop.
  const Vec2 along = stop - start;
  const double length_squared = along.squaredNorm();

  const int incident = incident_edge(other, normal);
  const std::array<int, 2> corners{incident, other.shape.next(incident)};
  std::array<Vec2, 2> end;
  std::array<double, 2> at;
  for (int i = 0; i < 2; ++i) {
    end[i] = other.corner(corners[i]);
    at[i] = along.dot(end[i] - start);
  }

  ContactPoints found;
  const auto add_incident_corner = [&](int i) {
    const double d = normal.dot(end[i] - start);
    if (d > margin) return;
    found.add({end[i], normal, d, Touching::corner_on_edge, other_is_a, corners[i], edge});
  };
  const bool is_beside =
      (at[0] < 0.0 && at[1] < 0.0) || (at[0] > length_squared && at[1] > length_squared);
  if (is_beside) {
    // Nothing is in common: corner is beside corner, and the nearer end stands for the contact.
    add_incident_corner(normal.dot(end[0] - start) <= normal.dot(end[1] - start) ? 0 : 1);
    return found;
  }
  const Vec2 incident_normal = other.normal(incident);
  for (int i = 0; i < 2; ++i) {
    if (at[i] >= 0.0 && at[i] <= length_squared) {
      add_incident_corner(i);
      continue;
    }
    // The incident edge is clipped at this end: there a corner of the reference polygon is over the
    // incident edge.
    const bool at_start = at[i] < 0.0;
    const Vec2& corner = at_start ? start : stop;
    const double d = incident_normal.dot(corner - end[0]);
    if (d > margin) continue;
    found.add({corner, incident_normal, d, Touching::corner_on_edge, !other_is_a,
               at_start ? edge : reference.shape.next(edge), incident});
  }
  return found;
}

}  // namespace

ContactPoints incident_corners(const geometry::Reference& reference, const geometry::Outline& a,
                               const Pose& body_a, const geometry::Outline& b, const Pose& body_b) {
  const int edge = reference.best.edge;
  const PlacedPolygon in_a{a, body_a};
  const PlacedPolygon in_b{b, body_b};
  const PlacedPolygon& side = reference.is_a ? in_a : in_b;
  const PlacedPolygon& other = reference.is_a ? in_b : in_a;
  const Vec2 start = side.corner(edge);
  const Vec2 normal = side.normal(edge);
  const int incident = incident_edge(other, normal);
  ContactPoints found;
  for (const int corner : {incident, other.shape.next(incident)}) {
    const Vec2 place = other.corner(corner);
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
  const PlacedPolygon in_a{a, body_a};
  const PlacedPolygon in_b{b, body_b};
  return reference.is_a ? clip_to_edge(in_a, reference.best.edge, in_b, false, margin)
                        : clip_to_edge(in_b, reference.best.edge, in_a, true, margin);
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
  for (int i = 0; i < a.corners && found.count < ContactPoints::max_points; ++i) {
    const Vec2 corner = body_a.position + body_a.heading.to_world(a.corner[i]);
    const double d = wall.normal.dot(corner) - wall.offset;
    if (d > margin) continue;
    found.add({corner, wall.normal, d, Touching::corner_on_edge, true, i});
  }
  return found;
}

}  // namespace mirocup::simulator::collision
