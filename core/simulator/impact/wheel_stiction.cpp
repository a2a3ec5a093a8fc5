// SPDX-License-Identifier: MIT
#include "core/simulator/impact/wheel_stiction.hpp"

#include "core/simulator/impact/delassus.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace mirocup::simulator::impact {

namespace {

// Returns the largest lateral speed of these robots, m/s.
double max_slip(std::span<const int> robots, std::span<const BodyState> bodies) {
  double fastest = 0.0;
  for (const int robot : robots) fastest = std::max(fastest, std::abs(bodies[robot].twist.left));
  return fastest;
}

}  // namespace

void arrest_slip(std::span<collision::Contact> contacts, std::span<const int> robots,
                 double max_impulse, std::span<const solver::InverseMass> mass,
                 std::span<BodyState> bodies, solver::BoxQp& problem) {
  const double fastest = max_slip(robots, bodies);
  if (fastest <= settings::differential_drive.slip_round_off) return;
  const BodySet touching = bodies_of(contacts);
  std::array<Twist, max_bodies> before;
  for_each_body(touching, [&](int i) { before[i] = bodies[i].twist; });

  // One problem: unknowns are first the contacts' impulses, then the ground's.
  std::array<solver::ConstraintRow, max_robots> wheels;
  const int first_wheels = static_cast<int>(contacts.size());
  const int n = first_wheels + static_cast<int>(robots.size());
  const auto row = [&](int i) -> const solver::ConstraintRow& {
    return i < first_wheels ? contacts[i].row : wheels[i - first_wheels];
  };
  problem.reset(n);
  for (int i = first_wheels; i < n; ++i) {
    wheels[i - first_wheels] = collision::lateral_wheel_row(robots[i - first_wheels]);
    problem.low[i] = -max_impulse;
    problem.high[i] = max_impulse;
  }
  for (int i = 0; i < n; ++i) problem.b[i] = collision::row_rate(row(i), bodies);
  assemble_delassus(n, row, mass, problem);
  problem.solve();
  for (int i = 0; i < n; ++i) collision::apply_impulse(row(i), problem.x[i], mass, bodies);
  for (const int robot : robots) {
    double& left = bodies[robot].twist.left;
    if (std::abs(left) <= settings::differential_drive.slip_round_off) left = 0.0;
  }
  if (max_slip(robots, bodies) >= fastest) {
    for_each_body(touching, [&](int i) { bodies[i].twist = before[i]; });
    return;
  }
  for (int i = 0; i < first_wheels; ++i) contacts[i].impact.impulse += problem.x[i];
}

void arrest_slow_slip(const collision::StaticWorld& world,
                      std::span<const trajectory::DriveReference> drives,
                      std::span<collision::Contact> contacts,
                      std::span<const solver::InverseMass> mass, std::span<BodyState> bodies,
                      solver::BoxQp& problem) {
  if (contacts.empty() || world.parameters.grip == infinite_grip) return;
  const double first = world.tolerances.first_touch_threshold;
  const double braking = world.parameters.grip * gravity;
  const double slip_of_series = std::sqrt(2.0 * braking * world.tolerances.series_height);
  BodySet touching;
  BodySet hit;
  std::array<double, max_partners> approach_in_series{};  // m/s, the fastest of each body
  for (const collision::Contact& c : contacts) {
    touching |= bodies_of(c.pair);
    if (c.impact.impulse == 0.0) continue;
    hit |= bodies_of(c.pair);
    if (c.impact.restitution_threshold <= first) continue;
    for (const int partner : {c.pair.a, c.pair.partner}) {
      double& approach = approach_in_series[partner];
      approach = std::max(approach, c.impact.approach);
    }
  }
  std::array<int, max_robots> slow;
  std::size_t count = 0;
  double max_limit = 0.0;  // m/s
  for (int i = 0; i < world.robots; ++i) {
    const double limit = !hit[i] ? world.tolerances.slow_motion
                                 : std::max(first, std::min(slip_of_series, approach_in_series[i]));
    const double slip = std::abs(bodies[i].twist.left);
    if (!touching[i] || !drives[i].wheels_on_ground || slip > limit) continue;
    slow[count++] = i;
    max_limit = std::max(max_limit, limit);
  }
  // The bound is the same for all: a robot that stands must be able to take the impulse that stops
  // another one.
  const double max_impulse = world.parameters.robot_mass * max_limit;
  arrest_slip(contacts, {slow.data(), count}, max_impulse, mass, bodies, problem);
}

}  // namespace mirocup::simulator::impact
