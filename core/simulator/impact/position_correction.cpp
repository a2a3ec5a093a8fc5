// SPDX-License-Identifier: MIT
#include "core/simulator/impact/position_correction.hpp"

#include <array>

namespace mirocup::simulator {

void add_shift(const ConstraintRow& row, double amount, std::span<const InverseMass> mass,
               std::span<Shift> shifts) {
  add_impulse(row.on_a, amount, mass[row.a], shifts[row.a]);
  if (row.b != no_body) add_impulse(row.on_b, amount, mass[row.b], shifts[row.b]);
}

BodyState moved_by(const BodyState& body, const Shift& by) {
  BodyState moved = body;
  moved.position += body.heading.to_world({by.forward, by.left});
  moved.heading = body.heading.turned(sincos(by.turn));
  return moved;
}

void push_apart(std::span<const Contact> contacts, std::span<const InverseMass> free_mass,
                std::span<BodyState> bodies, SoftProblem& problem) {
  const int n = static_cast<int>(contacts.size());
  problem.reset(free_mass);
  for (int i = 0; i < n; ++i) {
    problem.add(contacts[i].row);
    problem.b[i] = contacts[i].point.gap;
  }
  problem.solve();

  std::array<Shift, max_bodies> shifts{};
  BodySet moved;
  for (int i = 0; i < n; ++i) {
    if (problem.x[i] == 0.0) continue;
    add_shift(contacts[i].row, problem.x[i], free_mass, shifts);
    moved |= bodies_of(contacts[i].pair);
  }
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (moved[i]) bodies[i] = moved_by(bodies[i], shifts[i]);
  }
}

}  // namespace mirocup::simulator
