// SPDX-License-Identifier: MIT
#include "core/simulator/collision/collision_queries.hpp"

#include "core/geometry/separation.hpp"
#include "core/simulator/collision/time_of_impact.hpp"

#include <algorithm>
#include <cmath>

namespace mirocup::simulator::collision {

namespace {

const trajectory::Segment& obstacle_segment() {
  static const trajectory::Segment still =
      trajectory::still_segment(BodyState{}, 0.0, trajectory::never);
  return still;
}

double of_pair(const StaticWorld& world, const Pair& pair, const PerPair& value) {
  const bool ball = world.is_ball(pair.a);
  if (pair.with_obstacle()) return ball ? value.ball_wall : value.robot_wall;
  return ball ? value.ball_robot : value.robot_robot;
}

const geometry::Outline& end_wall_of(const StaticWorld& world, int obstacle) {
  return world.end_wall_outlines[obstacle - plane_walls];
}

// Calls f with the two of a pair, of which the second may be a wall, and the end of both segments.
template <class F>
double with_movers(const StaticWorld& world, const Pair& pair,
                   std::span<const trajectory::Segment> segments, F f) {
  const trajectory::Segment& a = segments[pair.a];
  const MovingOutline mover{world.shape(pair.a), a};
  if (pair.with_plane()) return f(mover, world.field->walls[pair.obstacle()], a.end);
  const trajectory::Segment& b = pair.with_obstacle() ? obstacle_segment() : segments[pair.partner];
  return f(mover, MovingOutline{partner_outline(world, pair), b}, std::min(a.end, b.end));
}

}  // namespace

StaticWorld make_static_world(const field::Field* field, const Parameters& parameters,
                              const Tolerances& tolerances, int robots, bool has_ball) {
  StaticWorld world;
  world.parameters = parameters;
  world.tolerances = tolerances;
  world.robots = robots;
  world.has_ball = has_ball;
  world.field = field;
  world.robot_outline = robot_outline(parameters);
  world.ball_outline = geometry::circle(parameters.ball_radius);
  world.reach_of_robots =
      world.robot_outline.radius + tolerances.contact_gap + world.robot_outline.radius;
  world.reach_of_ball =
      world.ball_outline.radius + tolerances.contact_gap + world.robot_outline.radius;
  if (field != nullptr) {
    for (int i = 0; i < end_walls; ++i)
      world.end_wall_outlines[i] = geometry::end_wall(field->posts[i]);
  }
  world.free_robot = free_robot_mass(parameters);
  world.grounded_robot = robot_mass(parameters, true);
  world.ball = ball_mass(parameters);
  return world;
}

double restitution(const StaticWorld& world, const Pair& pair) {
  return of_pair(world, pair, world.parameters.restitution);
}

double contact_friction(const StaticWorld& world, const Pair& pair) {
  return of_pair(world, pair, world.parameters.contact_friction);
}

const geometry::Outline& partner_outline(const StaticWorld& world, const Pair& pair) {
  return pair.with_obstacle() ? end_wall_of(world, pair.obstacle()) : world.shape(pair.partner);
}

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
  for (int i = 0; i < found.count && !list.full(); ++i) {
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
  const int a = at.point_on_a ? pair.a : pair.b();
  const int b = at.point_on_a ? pair.b() : pair.a;
  const geometry::Outline* edges = b != no_body        ? &world.shape(b)
                                   : pair.with_plane() ? nullptr
                                                       : &end_wall_of(world, pair.obstacle());
  const BodyState side = b != no_body ? bodies[b] : BodyState{};
  if (a != no_body && world.is_ball(a)) {
    const geometry::Outline& ball = world.ball_outline;
    at = (edges == nullptr
              ? contact_points(ball, bodies[a], world.field->walls[pair.obstacle()], infinity)
              : contact_points(ball, bodies[a], *edges, side, infinity))
             .points[0];
    return;
  }
  if (a != no_body) {
    at.point = bodies[a].position + bodies[a].heading.to_world(world.shape(a).corner[at.corner]);
  }
  double offset = 0.0;
  if (edges == nullptr) {
    offset = world.field->walls[pair.obstacle()].offset;
  } else {
    at.normal = side.heading.to_world(edges->normal[at.edge]);
    offset = edges->offset[at.edge] + at.normal.dot(side.position);
  }
  at.gap = at.normal.dot(at.point) - offset;
}

double clamped_gap(const StaticWorld& world, std::span<const BodyState> bodies, const Contact& c,
                   double line) {
  ContactPoint at = c.point;
  refresh_contact(world, bodies, c.pair, at);
  if (at.gap >= -line) return at.gap;
  return std::max(at.gap, gap(world, c.pair, bodies));
}

double first_time_below(const StaticWorld& world, const Pair& pair, double level,
                        std::span<const trajectory::Segment> segments, double t) {
  return with_movers(world, pair, segments, [&](const MovingOutline& a, const auto& b, double end) {
    return time_of_impact(a, b, level, t, end);
  });
}

double contact_time(const StaticWorld& world, const Pair& pair,
                    std::span<const trajectory::Segment> segments, double t, double sink) {
  return with_movers(world, pair, segments, [&](const MovingOutline& a, const auto& b, double end) {
    return time_of_impact_or_penetration(a, b, sink, t, end);
  });
}

}  // namespace mirocup::simulator::collision
