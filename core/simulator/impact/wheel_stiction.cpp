// SPDX-License-Identifier: MIT
#include "core/simulator/impact/wheel_stiction.hpp"

#include "core/simulator/impact/delassus.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace mirocup::simulator::impact {

namespace {

double max_slip(std::span<const int> robots, std::span<const BodyState> bodies) {
  double fastest = 0.0;
  for (const int robot : robots) fastest = std::max(fastest, std::abs(bodies[robot].twist.left));
  return fastest;
}

}  // namespace

void arrest_slip(std::span<collision::Contact> contacts, std::span<const int> robots, double most,
                 std::span<const solver::InverseMass> mass, std::span<BodyState> bodies,
                 solver::BoxQp& problem) {
  const double fastest = max_slip(robots, bodies);
  if (fastest <= trajectory::slip_round_off) return;
  std::array<BodyState, max_bodies> before;
  std::copy(bodies.begin(), bodies.end(), before.begin());

  std::array<solver::ConstraintRow, max_robots> wheels;
  const int first_wheels = static_cast<int>(contacts.size());
  const int n = first_wheels + static_cast<int>(robots.size());
  const auto row = [&](int i) -> const solver::ConstraintRow& {
    return i < first_wheels ? contacts[i].row : wheels[i - first_wheels];
  };
  problem.reset(n);
  for (int i = first_wheels; i < n; ++i) {
    wheels[i - first_wheels] = collision::lateral_wheel_row(robots[i - first_wheels]);
    problem.low[i] = -most;
    problem.high[i] = most;
  }
  for (int i = 0; i < n; ++i) problem.b[i] = collision::row_rate(row(i), bodies);
  assemble_delassus(n, row, mass, problem);
  problem.solve();
  for (int i = 0; i < n; ++i) collision::apply_impulse(row(i), problem.x[i], mass, bodies);
  for (const int robot : robots) {
    double& left = bodies[robot].twist.left;
    if (std::abs(left) <= trajectory::slip_round_off) left = 0.0;
  }
  if (max_slip(robots, bodies) >= fastest) {
    std::copy_n(before.begin(), bodies.size(), bodies.begin());
    return;
  }
  for (int i = 0; i < first_wheels; ++i) contacts[i].impact.impulse += problem.x[i];
}

void arrest_slow_slip(const collision::StaticWorld& world, const RestThresholds& thresholds,
                      std::span<const trajectory::DriveReference> drives,
                      std::span<collision::Contact> contacts,
                      std::span<const solver::InverseMass> mass, std::span<BodyState> bodies,
                      solver::BoxQp& problem) {
  if (contacts.empty() || world.parameters.grip == infinite_grip) return;
  BodySet touching;
  BodySet hit;
  for (const collision::Contact& c : contacts) {
    touching |= bodies_of(c.pair);
    if (c.impact.impulse != 0.0) hit |= bodies_of(c.pair);
  }
  std::array<int, max_robots> slow;
  std::size_t count = 0;
  double longest = 0.0;
  for (int i = 0; i < world.robots; ++i) {
    const double brief = hit[i] ? thresholds.min_slip_speed(i) : thresholds.slip_threshold();
    const double left = std::abs(bodies[i].twist.left);
    if (!touching[i] || !drives[i].wheels_on_ground || left > brief) continue;
    slow[count++] = i;
    longest = std::max(longest, brief);
  }
  // Those that stand must be able to take what stops the others.
  const double most = world.parameters.robot_mass * longest;
  arrest_slip(contacts, {slow.data(), count}, most, mass, bodies, problem);
}

}  // namespace mirocup::simulator::impact
