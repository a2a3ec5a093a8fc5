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

namespace mirocup::simulator {

InverseMass free_robot_mass(const Parameters& parameters);
InverseMass robot_mass(const Parameters& parameters, bool wheels_on_ground);
InverseMass ball_mass(const Parameters& parameters);

// Of a body's share of a gap's rate.
JacobianRow contact_row(const BodyState& body, const ContactPoint& contact);

struct Contact {
  Pair pair;
  int a = no_body;  // the point's side, or no_body if that is a wall's corner
  int b = no_body;  // the edge's side, or no_body if that is a wall
  ContactPoint at;
  JacobianRow row_a{};  // the rate of the gap is row_a . twist of a minus row_b . twist of b
  JacobianRow row_b{};
  double restitution = 0.0;
  double friction = 0.0;    // Coulomb's coefficient
  double rest_speed = 0.0;  // m/s: a slower approach does not bounce
  double approach = 0.0;    // m/s before the impact, positive if the bodies close
  double impulse = 0.0;     // N s along the normal, given by the impact
  bool holds = false;       // presses from here on: the gap stays zero
  bool is_kept = false;     // where it holds: its gap stays zero on the whole curve, for certain
  double force = 0.0;       // N, where it holds
};

// Sets its rows from where its bodies are.
void set_rows(std::span<const BodyState> bodies, Contact& contact);

CoupledRow row_of(const Contact& contact);

BodySet bodies_of(std::span<const Contact> contacts);

// The contacts of the bodies that touch at one instant.
struct ContactList {
  std::array<Contact, max_unknowns - max_bodies> list;
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

// The ground holds wheels as a contact does whose row is v_l.
Contact wheels_as_contact(int body);

// The rate of the contact's gap, m/s.
double gap_rate(const Contact& contact, std::span<const BodyState> bodies);

// J M^-1 J', 1/kg: what an impulse of 1 N s along the contact adds to the rate of its gap.
double give(const Contact& contact, std::span<const InverseMass> mass);

// What an impulse along a row of the Jacobian adds to one body's twist.
void add_impulse(const JacobianRow& row, double impulse, const InverseMass& mass, Twist& twist);

// Adds the impulse to the twists of both bodies.
void apply_impulse(const Contact& contact, double impulse, std::span<const InverseMass> mass,
                   std::span<BodyState> bodies);

}  // namespace mirocup::simulator
