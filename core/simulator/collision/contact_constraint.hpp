// SPDX-License-Identifier: MIT
//
// A contact as a constraint on velocities: its row of the contact Jacobian J, the rate of its gap,
// and the effect of an impulse along it on the bodies (Catto 2005, "Iterative dynamics with
// temporal coherence"). Positive rates open a gap; impulses and forces push the bodies apart.
//
// Rows are in the bodies' own frames, so they apply to twists. Uses model and solver (rows) only.
#pragma once

#include "core/simulator/collision/manifold.hpp"
#include "core/simulator/model/body_pair.hpp"
#include "core/simulator/model/parameters.hpp"
#include "core/simulator/solver/constraint_row.hpp"

#include <array>
#include <span>

namespace mirocup::simulator::collision {

// Returns the inverse mass of a robot whose wheels are lifted.
solver::InverseMass free_robot_mass(const Parameters& parameters);
// Returns the inverse mass of a robot. With wheels on the ground and infinite grip, no impulse
// moves it sideways.
solver::InverseMass robot_mass(const Parameters& parameters, bool wheels_on_ground);
// Returns the inverse mass of the ball, which rolls: it has no spin of its own.
solver::InverseMass ball_mass(const Parameters& parameters);

// Returns the velocity of the contact point along the normal, as a row on this body's twist.
solver::JacobianRow contact_row(const BodyState& body, const ContactPoint& contact);

// The coefficients of a pair of surfaces.
struct ContactMaterial {
  double restitution = 0.0;  // e in (21)
  double friction = 0.0;     // Coulomb's coefficient
};

// One impact at a contact. The threshold is set before the impact is resolved, the other fields by
// resolve_impacts().
struct ContactImpact {
  double restitution_threshold = 0.0;  // m/s: a slower approach does not bounce
  double approach = 0.0;               // m/s before the impact, positive if the gap closes
  double impulse = 0.0;                // N s along the normal
};

// The force of a resting contact. An active contact presses at this instant. It is also persistent
// if no equation of its contact cluster is redundant: then the equations hold its gap at zero on
// the whole curve, and no later time of impact is searched for it. Where equations are redundant,
// some forces merely keep their first value, so gaps may drift.
struct RestingForce {
  bool is_active = false;
  bool is_persistent = false;
  double force = 0.0;     // N along the normal, while it is active
  double friction = 0.0;  // N along the tangent for each N of `force`, if the contact slides
};

// A contact point of a pair, with all that impact/ and the rooms above it keep for the contact.
struct Contact {
  Pair pair;
  int a = no_body;              // the body on the point's side (see Touching); no_body: an end wall
  int b = no_body;              // the body on the edge's side (see Touching); no_body: a wall
  ContactPoint point;           // as of the last add_contacts() or refresh_contact()
  solver::ConstraintRow row{};  // the row whose rate is the rate of the gap
  ContactMaterial material{};
  ContactImpact impact{};
  RestingForce resting{};
};

// Sets the contact's row from its point and the poses of its bodies.
void set_row(std::span<const BodyState> bodies, Contact& contact);

// Returns the bodies that have one of these contacts.
BodySet bodies_of(std::span<const Contact> contacts);

// Every contact is one unknown of a solver; so are the wheels of a robot and the ball's rolling.
inline constexpr int max_contacts = solver::max_unknowns - max_bodies;

// Bodies that touch without overlapping form a planar graph, which has at most 3n - 6 edges, and a
// pair has at most two contacts. The other contacts are with obstacles.
static_assert(max_contacts >=
              ContactPoints::max_points * (3 * max_bodies - 6) + plane_walls + end_walls);

// The contacts of one instant. All contacts of a pair follow each other.
struct ContactList {
  std::array<Contact, max_contacts> list;
  int count = 0;
  int overflows = 0;  // contacts that were ignored because the list was full; never reset

  std::span<Contact> contacts() { return {list.data(), static_cast<std::size_t>(count)}; }
  std::span<const Contact> contacts() const {
    return {list.data(), static_cast<std::size_t>(count)};
  }
  bool full() const { return count == static_cast<int>(list.size()); }

  // Removes the contacts for which keep(contact) is false; the others stay in order.
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

// Calls visit(contacts) for each pair with its contacts, which follow each other.
template <class Visit>
void for_each_pair(std::span<const Contact> contacts, Visit visit) {
  for (std::size_t first = 0, last = 0; first < contacts.size(); first = last) {
    while (last < contacts.size() && contacts[last].pair == contacts[first].pair) ++last;
    visit(contacts.subspan(first, last - first));
  }
}

// Returns the row of a robot's lateral velocity v_l, along which the ground's force acts on its
// wheels.
solver::ConstraintRow lateral_wheel_row(int robot);

// Returns J v of a row, m/s. For a contact's row it is the rate of the gap.
double row_rate(const solver::ConstraintRow& row, std::span<const BodyState> bodies);

// Returns the inverse effective mass of a row, J M^-1 J', 1/kg: the change of its rate for an
// impulse of 1 N s along it.
double inverse_effective_mass(const solver::ConstraintRow& row,
                              std::span<const solver::InverseMass> mass);

// Adds M^-1 J' times an impulse, N s, to the twist of one body.
void add_impulse(const solver::JacobianRow& row, double impulse, const solver::InverseMass& mass,
                 Twist& twist);

// Adds M^-1 J' times an impulse, N s, to the twists of the row's bodies.
void apply_impulse(const solver::ConstraintRow& row, double impulse,
                   std::span<const solver::InverseMass> mass, std::span<BodyState> bodies);

}  // namespace mirocup::simulator::collision
