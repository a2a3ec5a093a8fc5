// SPDX-License-Identifier: MIT
//
// A contact as a constraint on velocities: its row of the Jacobian, the rate of its gap, and what an
// impulse along it does to the bodies.
#pragma once

#include "core/simulator/collision/manifold.hpp"
#include "core/simulator/model/body_pair.hpp"
#include "core/simulator/model/parameters.hpp"
#include "core/simulator/solver/constraint_row.hpp"

#include <array>
#include <span>

namespace mirocup::simulator::collision {

solver::InverseMass free_robot_mass(const Parameters& parameters);
solver::InverseMass robot_mass(const Parameters& parameters, bool wheels_on_ground);
solver::InverseMass ball_mass(const Parameters& parameters);

// One body's part of the row of a gap's rate.
solver::JacobianRow contact_row(const BodyState& body, const ContactPoint& contact);

// How a pair of surfaces answers an impact.
struct ContactMaterial {
  double restitution = 0.0;  // e in (12)
  double friction = 0.0;     // Coulomb's coefficient
};

// One impact at a contact. The threshold is set before the impact is resolved, the others by it.
struct ContactImpact {
  double restitution_threshold = 0.0;  // m/s: a slower approach does not bounce
  double approach = 0.0;               // m/s before the impact, positive if the bodies close
  double impulse = 0.0;                // N s along the normal
};

// The force of a contact that lasts.
struct RestingForce {
  bool is_active = false;      // the contact presses: its gap stays zero
  bool is_persistent = false;  // its gap is known to stay zero on the whole curve that follows
  double force = 0.0;          // N along the normal, while it is active
};

struct Contact {
  Pair pair;
  int a = no_body;              // the point's side, or no_body if that is a wall's corner
  int b = no_body;              // the edge's side, or no_body if that is a wall
  ContactPoint point;           // where
  solver::ConstraintRow row{};  // the rate of the gap
  ContactMaterial material{};
  ContactImpact impact{};
  RestingForce resting{};
};

// Sets its row from where its bodies are.
void set_row(std::span<const BodyState> bodies, Contact& contact);

BodySet bodies_of(std::span<const Contact> contacts);

// The contacts of the bodies that touch at one instant.
struct ContactList {
  std::array<Contact, solver::max_unknowns - max_bodies> list;
  int count = 0;

  std::span<Contact> contacts() { return {list.data(), static_cast<std::size_t>(count)}; }
  std::span<const Contact> contacts() const {
    return {list.data(), static_cast<std::size_t>(count)};
  }
  bool full() const { return count == static_cast<int>(list.size()); }

  // Drops those for which keep(contact) is false; the others stay in order.
  template <class Keep>
  void keep_if(Keep keep) {
    int kept = 0;
    for (int i = 0; i < count; ++i) {
      if (!keep(list[i])) continue;
      if (kept != i) list[kept] = list[i];
      ++kept;
    }
    count = kept;
  }
};

// Calls visit(contacts) for each pair, whose contacts all follow each other.
template <class Visit>
void for_each_pair(std::span<const Contact> contacts, Visit visit) {
  for (std::size_t first = 0, last = 0; first < contacts.size(); first = last) {
    while (last < contacts.size() && contacts[last].pair == contacts[first].pair) ++last;
    visit(contacts.subspan(first, last - first));
  }
}

// The row of a robot's sideways velocity v_l, along which the ground's force acts on its wheels.
solver::ConstraintRow lateral_wheel_row(int robot);

// The rate of a row, m/s: of a contact's row that of its gap.
double row_rate(const solver::ConstraintRow& row, std::span<const BodyState> bodies);

// The inverse effective mass of a row, J M^-1 J', 1/kg: what an impulse of 1 N s along the row adds to its rate.
double inverse_effective_mass(const solver::ConstraintRow& row,
                              std::span<const solver::InverseMass> mass);

// Adds to one body's twist what an impulse, N s, along its part of a row changes.
void add_impulse(const solver::JacobianRow& row, double impulse, const solver::InverseMass& mass,
                 Twist& twist);

// Adds an impulse, N s, along the row to the twists of its bodies.
void apply_impulse(const solver::ConstraintRow& row, double impulse,
                   std::span<const solver::InverseMass> mass, std::span<BodyState> bodies);

}  // namespace mirocup::simulator::collision
