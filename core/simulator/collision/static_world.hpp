// SPDX-License-Identifier: MIT
//
// The part of a world that does not change while it runs: parameters, tolerances, outlines, masses
// and obstacles. This room and all rooms above it take it by const reference. Uses model,
// trajectory and solver only.
#pragma once

#include "core/geometry/outline.hpp"
#include "core/simulator/model/body_pair.hpp"
#include "core/simulator/model/parameters.hpp"
#include "core/simulator/model/tolerances.hpp"
#include "core/simulator/solver/constraint_row.hpp"

#include <array>

namespace mirocup::simulator::collision {

// Plain data, made once by make_static_world() and then only read, so threads may share it. The
// field is not copied and must outlive it.
struct StaticWorld {
  Parameters parameters;
  Tolerances tolerances;
  int robots = 0;  // bodies 0 .. robots - 1; the ball, if there is one, is body `robots`
  bool has_ball = false;
  const field::Field* field = nullptr;  // null: no obstacles

  // Outlines of bodies are in their body's frame, those of end walls in the field's frame.
  geometry::Outline robot_outline;
  geometry::Outline ball_outline;
  std::array<geometry::Outline, end_walls> end_wall_outlines;  // set if there is a field
  solver::InverseMass free_robot;                              // wheels lifted
  solver::InverseMass grounded_robot;                          // wheels on the ground
  solver::InverseMass ball;
  // m between reference points: two bodies that are farther apart have no contact.
  double reach_of_robots = 0.0;  // of two robots
  double reach_of_ball = 0.0;    // of the ball and a robot

  int bodies() const { return robots + (has_ball ? 1 : 0); }
  bool is_ball(int body) const { return body == robots; }
  const geometry::Outline& shape(int body) const {
    return is_ball(body) ? ball_outline : robot_outline;
  }
  // Returns the reach that applies to two bodies, m.
  double reach(int i, int j) const {
    return is_ball(i) || is_ball(j) ? reach_of_ball : reach_of_robots;
  }
};

// Returns the static world of a field (null: no obstacles) with at most max_robots robots.
StaticWorld make_static_world(const field::Field* field, const Parameters& parameters,
                              const Tolerances& tolerances, int robots, bool has_ball);

// Returns the parameters' coefficient of restitution and of Coulomb friction for this kind of pair.
double restitution(const StaticWorld& world, const Pair& pair);
double contact_friction(const StaticWorld& world, const Pair& pair);

// Returns the outline of a pair's end wall, or null if its obstacle is a plane wall, which has
// none. The pair must be with an obstacle.
const geometry::Outline* end_wall_outline(const StaticWorld& world, const Pair& pair);

// Returns the outline of the pair's partner, which is a body or an end wall.
const geometry::Outline& partner_outline(const StaticWorld& world, const Pair& pair);

}  // namespace mirocup::simulator::collision
