// SPDX-License-Identifier: MIT
#include "core/simulator/impact/impact.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace mirocup::simulator::impact {

namespace {

// Slower approaches than this (m/s) are rounding.
constexpr double no_approach = 1e-13;

// Rounds of throwing back before everything that still approaches is stopped for good.
constexpr int max_rounds = 64;

double kinetic_energy(std::span<const collision::Contact> contacts,
                      std::span<const solver::InverseMass> mass,
                      std::span<const BodyState> bodies) {
  // Only bodies with a contact change; each counts once, at its first contact.
  double sum = 0.0;
  std::array<bool, max_bodies> seen{};
  const auto add = [&](int i) {
    if (i == no_body || seen[i]) return;
    seen[i] = true;
    const solver::InverseMass& m = mass[i];
    const Twist& v = bodies[i].twist;
    if (m.forward > 0.0) sum += v.forward * v.forward / m.forward;
    if (m.left > 0.0) sum += v.left * v.left / m.left;
    if (m.omega > 0.0) sum += v.omega * v.omega / m.omega;
  };
  for (const collision::Contact& c : contacts) {
    add(c.a);
    add(c.b);
  }
  return 0.5 * sum;
}

// Impulses that just stop the chosen contacts: problem.x[i] belongs to contacts[chosen[i]].
void stop(std::span<const collision::Contact> contacts, std::span<const int> chosen,
          std::span<const solver::InverseMass> mass, std::span<const BodyState> bodies,
          solver::BoxQp& problem) {
  const int n = static_cast<int>(chosen.size());
  problem.reset(n);
  for (int i = 0; i < n; ++i) {
    problem.b[i] = collision::row_rate(contacts[chosen[i]].row, bodies);
  }
  assemble_delassus(
      n, [&](int i) -> const solver::ConstraintRow& { return contacts[chosen[i]].row; }, mass,
      problem);
  problem.solve();
}

void apply(std::span<collision::Contact> contacts, std::span<const int> chosen, double sign,
           std::optional<double> common_restitution, std::span<const solver::InverseMass> mass,
           std::span<BodyState> bodies, const solver::BoxQp& problem) {
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    collision::Contact& c = contacts[chosen[i]];
    const double e = common_restitution.value_or(c.material.restitution);
    const double impulse = sign * (1.0 + e) * problem.x[i];
    collision::apply_impulse(c.row, impulse, mass, bodies);
    c.impact.impulse += impulse;
  }
}

// Equation (21).
void resolve_single(collision::Contact& c, std::span<const solver::InverseMass> mass,
                    std::span<BodyState> bodies) {
  collision::ContactImpact& impact = c.impact;
  if (impact.approach <= no_approach) return;
  const double e = impact.approach > impact.restitution_threshold ? c.material.restitution : 0.0;
  impact.impulse = (1.0 + e) * impact.approach / collision::inverse_effective_mass(c.row, mass);
  collision::apply_impulse(c.row, impact.impulse, mass, bodies);
}

}  // namespace

void stop_approaches(std::span<collision::Contact> contacts,
                     std::span<const solver::InverseMass> mass, std::span<BodyState> bodies,
                     solver::BoxQp& problem) {
  std::array<int, solver::max_unknowns> chosen;
  for (std::size_t i = 0; i < contacts.size(); ++i) chosen[i] = static_cast<int>(i);
  const std::span<const int> all(chosen.data(), contacts.size());
  stop(contacts, all, mass, bodies, problem);
  apply(contacts, all, 1.0, 0.0, mass, bodies, problem);
}

void resolve_impacts(std::span<collision::Contact> contacts,
                     std::span<const solver::InverseMass> mass, std::span<BodyState> bodies,
                     solver::BoxQp& problem) {
  for (collision::Contact& c : contacts) {
    c.impact.approach = -collision::row_rate(c.row, bodies);
    c.impact.impulse = 0.0;
  }
  if (contacts.size() == 1) {
    resolve_single(contacts[0], mass, bodies);
    return;
  }

  std::array<int, solver::max_unknowns> chosen;
  for (int round = 0; round < max_rounds; ++round) {
    std::size_t n = 0;
    bool some_bounce = false;
    for (std::size_t i = 0; i < contacts.size(); ++i) {
      const double approach = -collision::row_rate(contacts[i].row, bodies);
      if (approach > no_approach) chosen[n++] = static_cast<int>(i);
      some_bounce = some_bounce || approach > contacts[i].impact.restitution_threshold;
    }
    if (n == 0) return;
    if (!some_bounce) break;

    const std::span<const int> approaching(chosen.data(), n);
    stop(contacts, approaching, mass, bodies, problem);
    const double before = kinetic_energy(contacts, mass, bodies);
    apply(contacts, approaching, 1.0, std::nullopt, mass, bodies, problem);
    if (kinetic_energy(contacts, mass, bodies) > before * (1.0 + 1e-14)) {
      double least = 1.0;
      for (const int i : approaching) least = std::min(least, contacts[i].material.restitution);
      apply(contacts, approaching, -1.0, std::nullopt, mass, bodies, problem);
      apply(contacts, approaching, 1.0, least, mass, bodies, problem);
    }
  }

  // What still approaches does so slowly, or has been thrown back often enough.
  stop_approaches(contacts, mass, bodies, problem);
}

}  // namespace mirocup::simulator::impact
