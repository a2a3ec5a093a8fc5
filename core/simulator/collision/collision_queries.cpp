// SPDX-License-Identifier: MIT
#include "core/simulator/collision/collision_queries.hpp"

#include "core/simulator/collision/time_of_impact.hpp"

#include <algorithm>

namespace mirocup::simulator::collision {

namespace {

const trajectory::Segment& obstacle_segment() {
  static const trajectory::Segment still =
      trajectory::still_segment(BodyState{}, 0.0, trajectory::never);
  return still;
}

// Returns f(a, b, end): the pair's moving outlines, of which b may be a plane wall instead, and the
// time at which the first of their segments ends.
template <class F>
double with_moving_outlines(const StaticWorld& world, const Pair& pair,
                            std::span<const trajectory::Segment> segments, F f) {
  const trajectory::Segment& a = segments[pair.a];
  const MovingOutline moving{world.shape(pair.a), a};
  if (pair.with_plane()) return f(moving, world.field->walls[pair.obstacle()], a.end);
  const trajectory::Segment& b = pair.with_obstacle() ? obstacle_segment() : segments[pair.partner];
  return f(moving, MovingOutline{partner_outline(world, pair), b}, std::min(a.end, b.end));
}

}  // namespace

BodyState partner_body(const Pair& pair, std::span<const BodyState> bodies) {
  return pair.with_obstacle() ? BodyState{} : bodies[pair.partner];
}

geometry::Separation separation(const StaticWorld& world, const Pair& pair, const Pose& a,
                                const Pose& b) {
  const geometry::Outline& shape = world.shape(pair.a);
  if (pair.with_plane()) return separation(shape, a, world.field->walls[pair.obstacle()]);
  return separation(shape, a, partner_outline(world, pair), pair.with_obstacle() ? Pose{} : b);
}

void add_contacts(const StaticWorld& world, const Pair& pair, std::span<const BodyState> bodies,
                  double margin, ContactList& list) {
  const geometry::Outline& shape = world.shape(pair.a);
  const BodyState& a = bodies[pair.a];
  if (pair.with_plane()) {
    const field::Wall& wall = world.field->walls[pair.obstacle()];
    add_points(world, pair, bodies, contact_points(shape, a, wall, margin), list);
  } else {
    const BodyState b = partner_body(pair, bodies);
    const ContactPoints found = contact_points(shape, a, partner_outline(world, pair), b, margin);
    add_points(world, pair, bodies, found, list);
  }
}

void add_points(const StaticWorld& world, const Pair& pair, std::span<const BodyState> bodies,
                const ContactPoints& found, ContactList& list) {
  for (int i = 0; i < found.count; ++i) {
    if (list.full()) {
      ++list.overflows;
      continue;
    }
    Contact& c = list.list[list.count++];
    c = Contact{.pair = pair, .point = found.points[i]};
    c.a = c.point.point_on_a ? pair.a : pair.b();
    c.b = c.point.point_on_a ? pair.b() : pair.a;
    set_row(bodies, c);
    c.material = {restitution(world, pair), contact_friction(world, pair)};
  }
}

void refresh_contact(const StaticWorld& world, std::span<const BodyState> bodies, const Pair& pair,
                     ContactPoint& at) {
  const int point_side = at.point_on_a ? pair.a : pair.b();
  const int edge_side = at.point_on_a ? pair.b() : pair.a;
  const geometry::Outline* edges =
      edge_side != no_body ? &world.shape(edge_side) : end_wall_outline(world, pair);
  const BodyState edge_body = edge_side != no_body ? bodies[edge_side] : BodyState{};
  if (point_side != no_body && world.is_ball(point_side)) {
    const geometry::Outline& ball = world.ball_outline;
    const BodyState& body = bodies[point_side];
    at = (edges == nullptr
              ? contact_points(ball, body, world.field->walls[pair.obstacle()], infinity)
              : contact_points(ball, body, *edges, edge_body, infinity))
             .points[0];
    return;
  }
  if (point_side != no_body) {
    const BodyState& body = bodies[point_side];
    at.point = body.position + body.heading.to_world(world.shape(point_side).corner[at.corner]);
  }
  double offset = 0.0;
  if (edges == nullptr) {
    offset = world.field->walls[pair.obstacle()].offset;
  } else {
    at.normal = edge_body.heading.to_world(edges->normal[at.edge]);
    offset = edges->offset[at.edge] + at.normal.dot(edge_body.position);
  }
  at.gap = at.normal.dot(at.point) - offset;
}

double clamped_gap(const StaticWorld& world, std::span<const BodyState> bodies, const Contact& c,
                   double trusted_depth) {
  ContactPoint at = c.point;
  refresh_contact(world, bodies, c.pair, at);
  if (at.gap >= -trusted_depth) return at.gap;
  return std::max(at.gap, gap(world, c.pair, bodies));
}

double first_time_below(const StaticWorld& world, const Pair& pair, double level,
                        std::span<const trajectory::Segment> segments, double t) {
  return with_moving_outlines(world, pair, segments,
                              [&](const MovingOutline& a, const auto& b, double end) {
                                return time_of_impact(a, b, level, t, end);
                              });
}

double contact_time(const StaticWorld& world, const Pair& pair,
                    std::span<const trajectory::Segment> segments, double t, double penetration,
                    const std::optional<geometry::Reference>& reference) {
  return with_moving_outlines(
      world, pair, segments, [&](const MovingOutline& a, const auto& b, double end) {
        return time_of_impact_or_penetration(a, b, penetration, t, end, reference);
      });
}

}  // namespace mirocup::simulator::collision
