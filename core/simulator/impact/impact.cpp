// SPDX-License-Identifier: MIT
#include "core/simulator/impact/impact.hpp"

#include "core/base/assert.hpp"
#include "core/simulator/model/solver_settings.hpp"

#include <algorithm>
#include <array>
#include <optional>

namespace mirocup::simulator::impact {

namespace {

// Returns the kinetic energy of the bodies that have a contact: no others change.
double kinetic_energy(std::span<const collision::Contact> contacts,
                      std::span<const solver::InverseMass> mass,
                      std::span<const BodyState> bodies) {
  double sum = 0.0;
  std::array<bool, max_bodies> seen{};  // a body counts once, at its first contact
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

// Sets problem.x to the smallest impulses that stop the chosen contacts: problem.x[i] is that of
// contacts[chosen[i]].
void solve_stopping_impulses(std::span<const collision::Contact> contacts,
                             std::span<const int> chosen, std::span<const solver::InverseMass> mass,
                             std::span<const BodyState> bodies, solver::BoxQp& problem) {
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

// Applies the stopping impulses times (1 + e); with the sign -1 it undoes that. e is the common
// restitution if it is given, else each contact's own.
void apply_stopping_impulses(std::span<collision::Contact> contacts, std::span<const int> chosen,
                             double sign, std::optional<double> common_restitution,
                             std::span<const solver::InverseMass> mass, std::span<BodyState> bodies,
                             const solver::BoxQp& problem) {
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    collision::Contact& c = contacts[chosen[i]];
    const double e = common_restitution.value_or(c.material.restitution);
    const double impulse = sign * (1.0 + e) * problem.x[i];
    collision::apply_impulse(c.row, impulse, mass, bodies);
    c.impact.impulse += impulse;
  }
}

// One round: stops the approaching contacts and throws them back.
//
// With the same e for all contacts a round cannot add energy. With different ones it can: the
// impulse that stops a contact of small e also stems from contacts of large e. Then the round is
// undone and redone with the smallest e of its contacts.
void reflect(std::span<collision::Contact> contacts, std::span<const int> approaching,
             std::span<const solver::InverseMass> mass, std::span<BodyState> bodies,
             solver::BoxQp& problem) {
  solve_stopping_impulses(contacts, approaching, mass, bodies, problem);
  const double before = kinetic_energy(contacts, mass, bodies);
  apply_stopping_impulses(contacts, approaching, 1.0, std::nullopt, mass, bodies, problem);
  const double max_energy = before * (1.0 + settings::impact.energy_round_off);
  if (kinetic_energy(contacts, mass, bodies) <= max_energy) return;

  double min_restitution = 1.0;
  for (const int i : approaching) {
    min_restitution = std::min(min_restitution, contacts[i].material.restitution);
  }
  apply_stopping_impulses(contacts, approaching, -1.0, std::nullopt, mass, bodies, problem);
  apply_stopping_impulses(contacts, approaching, 1.0, min_restitution, mass, bodies, problem);
}

// Equation (21).
void resolve_single(collision::Contact& c, std::span<const solver::InverseMass> mass,
                    std::span<BodyState> bodies) {
  collision::ContactImpact& impact = c.impact;
  if (impact.approach <= settings::impact.min_approach) return;
  const double e = impact.approach > impact.restitution_threshold ? c.material.restitution : 0.0;
  impact.impulse = (1.0 + e) * impact.approach / collision::inverse_effective_mass(c.row, mass);
  collision::apply_impulse(c.row, impact.impulse, mass, bodies);
}

}  // namespace

void stop_approaches(std::span<collision::Contact> contacts,
                     std::span<const solver::InverseMass> mass, std::span<BodyState> bodies,
                     solver::BoxQp& problem) {
  MIROCUP_ASSERT(contacts.size() <= collision::max_contacts);
  // Contacts that separate get an impulse of zero.
  std::array<int, collision::max_contacts> indices;
  for (std::size_t i = 0; i < contacts.size(); ++i) indices[i] = static_cast<int>(i);
  const std::span<const int> all(indices.data(), contacts.size());
  solve_stopping_impulses(contacts, all, mass, bodies, problem);
  apply_stopping_impulses(contacts, all, 1.0, 0.0, mass, bodies, problem);
}

void resolve_impacts(std::span<collision::Contact> contacts,
                     std::span<const solver::InverseMass> mass, std::span<BodyState> bodies,
                     solver::BoxQp& problem) {
  MIROCUP_ASSERT(contacts.size() <= collision::max_contacts);
  for (collision::Contact& c : contacts) {
    c.impact.approach = -collision::row_rate(c.row, bodies);
    c.impact.impulse = 0.0;
  }
  if (contacts.size() == 1) {
    resolve_single(contacts[0], mass, bodies);
    return;
  }

  std::array<int, collision::max_contacts> indices;
  for (int round = 0; round < settings::impact.max_rounds; ++round) {
    std::size_t count = 0;
    bool some_approach = false;
    bool some_bounce = false;
    for (std::size_t i = 0; i < contacts.size(); ++i) {
      const double approach = -collision::row_rate(contacts[i].row, bodies);
      some_approach = some_approach || approach > settings::impact.min_approach;
      if (approach <= settings::impact.resting_approach) continue;
      indices[count++] = static_cast<int>(i);
      some_bounce = some_bounce || approach > contacts[i].impact.restitution_threshold;
    }
    if (!some_approach) return;
    if (!some_bounce) break;
    reflect(contacts, {indices.data(), count}, mass, bodies, problem);
  }

  // The contacts that still approach are slower than their thresholds, or have had all rounds.
  stop_approaches(contacts, mass, bodies, problem);
}

}  // namespace mirocup::simulator::impact
