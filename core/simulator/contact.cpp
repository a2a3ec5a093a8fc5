// SPDX-License-Identifier: MIT
#include "core/simulator/contact.hpp"

#include <algorithm>
#include <cmath>

namespace mirocup::simulator {

namespace {

// The pose of `body` in the frame of `of`.
struct Relative {
  Vec2 position;
  Heading heading;
};
Relative relative(const Body& body, const Body& of) {
  return {of.heading.to_body(body.position - of.position), body.heading.seen_from(of.heading)};
}

// The corner that is farthest against `normal` (in the polygon's frame): where along it, m.
double nearest_corner(const Shape& polygon, const Vec2& normal) {
  double nearest = infinity;
  for (int i = 0; i < polygon.corners; ++i) {
    nearest = std::min(nearest, normal.dot(polygon.corner[i]));
  }
  return nearest;
}

Axis axis_to_centre(const Body& body_a, const Shape& b, const Body& body_b) {
  return nearest_axis(b, body_b.heading.to_body(body_a.position - body_b.position));
}

// The edge of `other` that faces against `normal` most, both in the field's frame.
int incident_edge(const Shape& other, const Body& body, const Vec2& normal) {
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
ContactPoints over_edge(const Shape& reference, const Body& body, int edge, const Shape& other,
                        const Body& other_body, bool other_is_a, double margin) {
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

Axis nearest_axis(const Shape& polygon, const Vec2& point) {
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

// The edge that faces the other's middle comes first: most others are out of question then.
EdgeSeparation best_edge(const Shape& reference, const Shape& other, const Vec2& position,
                         const Heading& heading) {
  std::array<double, max_corners> of_middle{};
  int facing = 0;
  for (int edge = 0; edge < reference.corners; ++edge) {
    of_middle[edge] = reference.normal[edge].dot(position) - reference.offset[edge];
    if (of_middle[edge] > of_middle[facing]) facing = edge;
  }
  const auto separation_of = [&](int edge) {
    return of_middle[edge] + nearest_corner(other, heading.to_body(reference.normal[edge]));
  };
  EdgeSeparation best{facing, separation_of(facing)};
  const double reach = other.inner_radius * (1.0 - 1e-9);  // at least so far towards any edge
  for (int edge = 0; edge < reference.corners; ++edge) {
    if (edge == facing || of_middle[edge] - reach <= best.separation) continue;
    const double separation = separation_of(edge);
    if (separation > best.separation) best = {edge, separation};
  }
  return best;
}

Reference reference_of(const Shape& a, const Body& body_a, const Shape& b, const Body& body_b,
                       double margin) {
  const Relative b_in_a = relative(body_b, body_a);
  const EdgeSeparation of_a = best_edge(a, b, b_in_a.position, b_in_a.heading);
  if (of_a.separation > margin) return {true, of_a};
  const Relative a_in_b = relative(body_a, body_b);
  const EdgeSeparation of_b = best_edge(b, a, a_in_b.position, a_in_b.heading);
  if (of_a.separation >= of_b.separation) return {true, of_a};
  return {false, of_b};
}

double separation_from(const Reference& reference, const Shape& a, const Body& body_a,
                       const Shape& b, const Body& body_b) {
  const int edge = reference.best.edge;
  const Shape& side = reference.is_a ? a : b;
  const Relative other = reference.is_a ? relative(body_b, body_a) : relative(body_a, body_b);
  return side.normal[edge].dot(other.position) - side.offset[edge] +
         nearest_corner(reference.is_a ? b : a, other.heading.to_body(side.normal[edge]));
}

ContactPoints corners_over(const Reference& reference, const Shape& a, const Body& body_a,
                           const Shape& b, const Body& body_b) {
  const int edge = reference.best.edge;
  const Shape& side = reference.is_a ? a : b;
  const Body& body = reference.is_a ? body_a : body_b;
  const Shape& other = reference.is_a ? b : a;
  const Body& other_body = reference.is_a ? body_b : body_a;
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

Separation separation(const Shape& a, const Body& body_a, const Shape& b, const Body& body_b) {
  if (a.is_circle()) {
    const Axis axis = axis_to_centre(body_a, b, body_b);
    return {axis.separation - a.radius, body_b.heading.to_world(axis.normal), a.radius,
            axis.offset};
  }
  const Reference reference = reference_of(a, body_a, b, body_b);
  const double gap = reference.best.separation;
  const Shape& side = reference.is_a ? a : b;
  const Heading& heading = reference.is_a ? body_a.heading : body_b.heading;
  const Vec2 outwards = heading.to_world(side.normal[reference.best.edge]);
  const Vec2 normal = reference.is_a ? Vec2{-outwards} : outwards;
  const double own_reach = side.offset[reference.best.edge];
  const double other_reach = normal.dot(body_a.position - body_b.position) - own_reach - gap;
  return reference.is_a ? Separation{gap, normal, own_reach, other_reach}
                        : Separation{gap, normal, other_reach, own_reach};
}

Separation separation(const Shape& a, const Body& body_a, const field::Wall& wall) {
  double reach = a.radius;
  if (!a.is_circle()) reach = -nearest_corner(a, body_a.heading.to_body(wall.normal));
  return {wall.normal.dot(body_a.position) - wall.offset - reach, wall.normal, reach, 0.0};
}

ContactPoints contact_points(const Shape& a, const Body& body_a, const Shape& b, const Body& body_b,
                             double margin) {
  if (a.is_circle()) {
    ContactPoints found;
    const Axis axis = axis_to_centre(body_a, b, body_b);
    const double d = axis.separation - a.radius;
    if (d > margin) return found;
    const Vec2 normal = body_b.heading.to_world(axis.normal);
    found.add({body_a.position - a.radius * normal, normal, d,
               axis.corner < 0 ? Touching::circle_on_edge : Touching::circle_on_corner, true,
               axis.corner, axis.edge});
    return found;
  }
  const Reference reference = reference_of(a, body_a, b, body_b, margin);
  if (reference.best.separation > margin) return {};
  return reference.is_a ? over_edge(a, body_a, reference.best.edge, b, body_b, false, margin)
                        : over_edge(b, body_b, reference.best.edge, a, body_a, true, margin);
}

ContactPoints contact_points(const Shape& a, const Body& body_a, const field::Wall& wall,
                             double margin) {
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

}  // namespace mirocup::simulator
