// SPDX-License-Identifier: MIT
#include "core/simulator/collision/static_world.hpp"

#include "core/base/assert.hpp"
#include "core/simulator/collision/contact_constraint.hpp"

namespace mirocup::simulator::collision {

namespace {

double value_for(const StaticWorld& world, const Pair& pair, const PerPair& value) {
  const bool ball = world.is_ball(pair.a);
  if (pair.with_obstacle()) return ball ? value.ball_wall : value.robot_wall;
  return ball ? value.ball_robot : value.robot_robot;
}

}  // namespace

StaticWorld make_static_world(const field::Field* field, const Parameters& parameters,
                              const Tolerances& tolerances, int robots, bool has_ball) {
  MIROCUP_ASSERT(robots >= 0 && robots <= max_robots);
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
  return value_for(world, pair, world.parameters.restitution);
}

double contact_friction(const StaticWorld& world, const Pair& pair) {
  return value_for(world, pair, world.parameters.contact_friction);
}

const geometry::Outline* end_wall_outline(const StaticWorld& world, const Pair& pair) {
  MIROCUP_ASSERT(pair.with_obstacle());
  if (pair.with_plane()) return nullptr;
  return &world.end_wall_outlines[pair.obstacle() - plane_walls];
}

const geometry::Outline& partner_outline(const StaticWorld& world, const Pair& pair) {
  MIROCUP_ASSERT(!pair.with_plane());
  return pair.with_obstacle() ? *end_wall_outline(world, pair) : world.shape(pair.partner);
}

}  // namespace mirocup::simulator::collision
