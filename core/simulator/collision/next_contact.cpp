// SPDX-License-Identifier: MIT
#include "core/simulator/collision/next_contact.hpp"

#include "core/base/assert.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace mirocup::simulator::collision {

namespace {

// A robot's corner that presses on an edge of another body or on a wall: the robot can only slide
// along the edge and turn around this corner.
struct Pivot {
  const geometry::Outline& shape;  // the robot's
  Vec2 corner;                     // in the robot's frame
  int corner_index;
  const trajectory::Segment& robot;
  const trajectory::Segment* edge;  // the segment of the edge's body; null: a wall
  Vec2 normal;                      // the edge's, in its body's frame, or a wall's in the field's

  double length() const {
    return edge == nullptr ? robot.end - robot.begin : std::min(robot.end, edge->end) - robot.begin;
  }
};

Pivot pivot_of(const StaticWorld& world, const Contact& c,
               std::span<const trajectory::Segment> segments) {
  const geometry::Outline& shape = world.shape(c.a);
  const bool on_wall = c.b == no_body;
  return {.shape = shape,
          .corner = shape.corner[c.point.corner],
          .corner_index = c.point.corner,
          .robot = segments[c.a],
          .edge = on_wall ? nullptr : &segments[c.b],
          .normal = on_wall ? c.point.normal : world.shape(c.b).normal[c.point.edge]};
}

// Returns bounds of the angle, rad, by which the robot turns against the edge: the integral of the
// relative turn rate, term by term.
trajectory::Range relative_rotation(const Pivot& pivot) {
  const trajectory::Series rate =
      pivot.edge == nullptr ? pivot.robot.omega : pivot.robot.omega - pivot.edge->omega;
  trajectory::Range turned{0.0, 0.0};
  double power = 1.0;
  for (int k = 0; k < rate.terms; ++k) {
    power *= pivot.length();
    const double by = rate[k] * power / (k + 1);
    turned.low += std::min(by, 0.0);
    turned.high += std::max(by, 0.0);
  }
  return turned;
}

// Cosine and sine of the angle from the edge's frame to the robot's.
struct RelativeHeading {
  trajectory::Series cos, sin;
};

RelativeHeading relative_heading(const Pivot& pivot) {
  const trajectory::Segment& a = pivot.robot;
  if (pivot.edge == nullptr) return {a.cos, a.sin};
  const trajectory::Segment& b = *pivot.edge;
  return {sum_of_products(b.cos, a.cos, b.sin, a.sin),
          difference_of_products(b.cos, a.sin, b.sin, a.cos)};
}

// Returns a lower bound of the height above the edge's line, m, of a point of the robot while it
// turns by an angle within the bounds. `arm` is the point seen from the pivot, `normal` the edge's
// normal at the start, both in the robot's frame.
//
// With up = n . arm and across = arm x n the height after turning by q is
//   h(q) = up cos q + across sin q.
// Taylor's theorem gives |cos q - 1| <= q^2 / 2 and |sin q - q| <= |q|^3 / 6. So, with
// max_q = max |q|,
//   h(q) >= up + across q - max_q^2 (|up| / 2 + max_q |across| / 6),
// and the linear term is smallest at one of the bounds of q.
double lowest_height(const Vec2& arm, const Vec2& normal, const trajectory::Range& rotation) {
  const double max_q = std::max(-rotation.low, rotation.high);
  const double up = normal.dot(arm);
  const double across = cross(arm, normal);
  return up + std::min(across * rotation.low, across * rotation.high) -
         max_q * max_q * (0.5 * std::abs(up) + max_q * std::abs(across) / 6.0);
}

}  // namespace

bool is_separating_edge(const StaticWorld& world, const Contact& c) {
  if (!c.resting.is_active || !c.resting.is_persistent) return false;
  if (c.point.kind != Touching::corner_on_edge) return true;
  const bool on_end_wall = c.pair.with_obstacle() && c.pair.obstacle() >= plane_walls;
  if (c.a == no_body || on_end_wall) return false;
  const geometry::Outline& shape = world.shape(c.a);
  const Vec2 n{c.row.on_a[0], c.row.on_a[1]};
  const double line = n.dot(shape.corner[c.point.corner]) - world.tolerances.contact_gap;
  return std::all_of(shape.corner.begin(), shape.corner.begin() + shape.corners,
                     [&](const Vec2& corner) { return n.dot(corner) >= line; });
}

double next_corner_contact(const StaticWorld& world, const Contact& contact, bool others,
                           std::span<const trajectory::Segment> segments, double penetration) {
  if (others || contact.point.kind != Touching::corner_on_edge) return trajectory::never;
  MIROCUP_ASSERT(contact.a != no_body);
  const Pivot pivot = pivot_of(world, contact, segments);

  // First the corners that the bound of their heights does not rule out. Most robots turn too
  // little.
  const trajectory::Range rotation = relative_rotation(pivot);
  const Vec2 normal{contact.row.on_a[0], contact.row.on_a[1]};  // at the start, robot's frame
  std::array<Vec2, geometry::max_corners> arms;
  int count = 0;
  for (int i = 0; i < pivot.shape.corners; ++i) {
    if (i == pivot.corner_index) continue;
    const Vec2 arm = pivot.shape.corner[i] - pivot.corner;
    if (lowest_height(arm, normal, rotation) <= world.tolerances.contact_gap) arms[count++] = arm;
  }
  if (count == 0) return trajectory::never;

  // Then the exact search among these.
  const RelativeHeading heading = relative_heading(pivot);
  double first = trajectory::never;
  for (int i = 0; i < count; ++i) {
    const trajectory::Series height =
        pivot.normal.dot(arms[i]) * heading.cos + cross(arms[i], pivot.normal) * heading.sin;
    const double level = std::min(height[0], 0.0) - penetration;
    first = std::min(first, first_crossing(height, level, 0.0, std::min(first, pivot.length())));
  }
  return pivot.robot.begin + first;
}

std::optional<double> next_contact_time(const StaticWorld& world, const Pair& pair,
                                        std::span<const Contact> contacts,
                                        std::span<const trajectory::Segment> segments,
                                        double penetration) {
  const Contact* pressing = nullptr;
  bool others = false;
  for (const Contact& c : contacts) {
    if (!(c.pair == pair) || !is_separating_edge(world, c)) continue;
    others = pressing != nullptr;
    pressing = &c;
  }
  if (pressing == nullptr) return std::nullopt;
  return next_corner_contact(world, *pressing, others, segments, penetration);
}

}  // namespace mirocup::simulator::collision
