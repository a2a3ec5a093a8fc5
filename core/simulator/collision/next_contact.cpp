// SPDX-License-Identifier: MIT
#include "core/simulator/collision/next_contact.hpp"

#include <algorithm>
#include <cmath>

namespace mirocup::simulator::collision {

namespace {

// How a corner of a robot presses on an edge that turns with another body, or on a wall.
struct Pivot {
  const geometry::Outline& shape;  // of the robot
  Vec2 corner;                     // that presses, in the robot's frame
  int corner_index;
  const trajectory::Segment& robot;
  const trajectory::Segment* edge;  // of the edge's body; null: a wall
  Vec2 normal;                      // of the edge, in its body's frame or the field's

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

// By how much the robot turns against the edge, between these bounds.
trajectory::Range turn_over(const Pivot& pivot) {
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

struct RelativeHeading {
  trajectory::Series cos, sin;
};

RelativeHeading relative_heading(const Pivot& pivot) {
  const trajectory::Segment& a = pivot.robot;
  if (pivot.edge == nullptr) return {a.cos, a.sin};
  const trajectory::Segment& b = *pivot.edge;
  return {b.cos * a.cos + b.sin * a.sin, b.cos * a.sin - b.sin * a.cos};
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
                           std::span<const trajectory::Segment> segments, double sink) {
  if (others || contact.point.kind != Touching::corner_on_edge) return trajectory::never;
  const Pivot pivot = pivot_of(world, contact, segments);
  const trajectory::Range turned = turn_over(pivot);
  const double most = std::max(-turned.low, turned.high);
  const Vec2 n{contact.row.on_a[0], contact.row.on_a[1]};  // in the robot's frame, at the begin
  std::array<Vec2, geometry::max_corners> arms;
  int close = 0;
  for (int i = 0; i < pivot.shape.corners; ++i) {
    if (i == pivot.corner_index) continue;
    const Vec2 arm = pivot.shape.corner[i] - pivot.corner;
    // The height is up cos(turned) + across sin(turned), which is at least this.
    const double up = n.dot(arm);
    const double across = cross(arm, n);
    const double least = up + std::min(across * turned.low, across * turned.high) -
                         most * most * (0.5 * std::abs(up) + most * std::abs(across) / 6.0);
    if (least <= world.tolerances.contact_gap) arms[close++] = arm;
  }
  if (close == 0) return trajectory::never;

  const RelativeHeading heading = relative_heading(pivot);
  double first = trajectory::never;
  for (int i = 0; i < close; ++i) {
    const trajectory::Series height =
        pivot.normal.dot(arms[i]) * heading.cos + cross(arms[i], pivot.normal) * heading.sin;
    const double level = std::min(height[0], 0.0) - sink;
    first = std::min(first, first_crossing(height, level, 0.0, std::min(first, pivot.length())));
  }
  return pivot.robot.begin + first;
}

std::optional<double> next_contact_time(const StaticWorld& world, const Pair& pair,
                                        std::span<const Contact> contacts,
                                        std::span<const trajectory::Segment> segments,
                                        double sink) {
  const Contact* pressing = nullptr;
  bool others = false;
  for (const Contact& c : contacts) {
    if (!(c.pair == pair) || !is_separating_edge(world, c)) continue;
    others = pressing != nullptr;
    pressing = &c;
  }
  if (pressing == nullptr) return std::nullopt;
  return next_corner_contact(world, *pressing, others, segments, sink);
}

}  // namespace mirocup::simulator::collision
