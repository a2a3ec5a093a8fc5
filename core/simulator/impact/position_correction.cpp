// SPDX-License-Identifier: MIT
#include "core/simulator/impact/position_correction.hpp"

#include <array>

namespace mirocup::simulator::impact {

void add_displacement(const solver::ConstraintRow& row, double amount,
                      std::span<const solver::InverseMass> mass,
                      std::span<Displacement> displacements) {
  collision::add_impulse(row.on_a, amount, mass[row.a], displacements[row.a]);
  if (row.b != no_body) collision::add_impulse(row.on_b, amount, mass[row.b], displacements[row.b]);
}

BodyState displaced(const BodyState& body, const Displacement& by) {
  BodyState moved = body;
  moved.position += body.heading.to_world({by.forward, by.left});
  moved.heading = body.heading.turned(sincos(by.omega));
  return moved;
}

void project_positions(std::span<const collision::Contact> contacts,
                       std::span<const solver::InverseMass> free_mass, std::span<BodyState> bodies,
                       solver::RegularizedQp& problem) {
  const int n = static_cast<int>(contacts.size());
  problem.reset(free_mass);
  for (int i = 0; i < n; ++i) {
    problem.add(contacts[i].row);
    problem.b[i] = contacts[i].point.gap;
  }
  problem.solve();

  std::array<Displacement, max_bodies> displacements{};
  BodySet moved;
  for (int i = 0; i < n; ++i) {
    if (problem.x[i] == 0.0) continue;
    add_displacement(contacts[i].row, problem.x[i], free_mass, displacements);
    moved |= bodies_of(contacts[i].pair);
  }
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (moved[i]) bodies[i] = displaced(bodies[i], displacements[i]);
  }
}

}  // namespace mirocup::simulator::impact
