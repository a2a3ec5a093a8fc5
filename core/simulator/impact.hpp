// SPDX-License-Identifier: MIT
//
// Impacts: what bodies that run into each other do to their velocities in no time.
//
// One contact is equation (21): v_rel+ = -e v_rel-. Several at once go beyond the paper, after
// Smith, Kaufman, Vouga, Tamstorf and Grinspun 2012, "Reflections on simultaneous impact": all
// contacts that approach are first stopped together, then thrown back by (1 + e) times what stopped
// them, again and again until none approaches. A row of equal bodies hands the impulse through, a
// symmetric hit stays symmetric, and energy never rises.
#pragma once

#include "core/simulator/complementarity.hpp"
#include "core/simulator/contact.hpp"
#include "core/simulator/coupled_rows.hpp"
#include "core/simulator/pair.hpp"
#include "core/simulator/parameters.hpp"

#include <array>
#include <span>

namespace mirocup::simulator {

InverseMass free_robot_mass(const Parameters& parameters);
InverseMass robot_mass(const Parameters& parameters, bool wheels_on_ground);
InverseMass ball_mass(const Parameters& parameters);

// Of a body's share of a gap's rate.
JacobianRow contact_row(const Body& body, const ContactPoint& contact);

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
void set_rows(std::span<const Body> bodies, Contact& contact);

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
double gap_rate(const Contact& contact, std::span<const Body> bodies);

// J M^-1 J', 1/kg: what an impulse of 1 N s along the contact adds to the rate of its gap.
double give(const Contact& contact, std::span<const InverseMass> mass);

// The bodies of several contacts, each with its rows: only contacts that share a body are coupled.
class SharedBodies {
 public:
  SharedBodies() { newest_.fill(none); }

  void add(int unknown, const Contact& contact) {
    if (contact.a != no_body) add(unknown, contact.a, contact.row_a, 1.0);
    if (contact.b != no_body) add(unknown, contact.b, contact.row_b, -1.0);
  }
  // Adds J M^-1 J' to the matrix of a problem, or of equations.
  template <class Matrix>
  void couple(std::span<const InverseMass> mass, Matrix& matrix) const {
    for (std::size_t body = 0; body < mass.size(); ++body) {
      const InverseMass& m = mass[body];
      for (int i = newest_[body]; i != none; i = rows_[i].before) {
        const Row& p = rows_[i];
        const JacobianRow moved{p.row[0] * m.forward, p.row[1] * m.left, p.row[2] * m.turn};
        for (int j = i; j != none; j = rows_[j].before) {
          const Row& q = rows_[j];
          const double by = moved[0] * q.row[0] + moved[1] * q.row[1] + moved[2] * q.row[2];
          matrix.add_to_a(p.unknown, q.unknown, by);
        }
      }
    }
  }

 private:
  static constexpr int none = -1;
  struct Row {
    JacobianRow row;
    int unknown;
    int before;  // the body's row before this one
  };

  void add(int unknown, int body, const JacobianRow& row, double sign) {
    rows_[count_] = {{sign * row[0], sign * row[1], sign * row[2]}, unknown, newest_[body]};
    newest_[body] = count_++;
  }

  std::array<int, max_bodies> newest_;
  std::array<Row, 2 * max_unknowns> rows_;
  int count_ = 0;
};

// Sets the matrix of a problem that was reset; contact_of(i) is the contact of unknown i < count.
template <class ContactOf>
void set_couplings(int count, ContactOf contact_of, std::span<const InverseMass> mass,
                   BoxProblem& problem) {
  SharedBodies bodies;
  for (int i = 0; i < count; ++i) bodies.add(i, contact_of(i));
  bodies.couple(mass, problem);
  if (!problem.is_large()) return;
  SoftProblem& soft = problem.to_begin_softly(mass);
  for (int i = 0; i < count; ++i) soft.add(row_of(contact_of(i)));
}

// What an impulse along a row of the Jacobian adds to one body's twist.
void add_impulse(const JacobianRow& row, double impulse, const InverseMass& mass, Twist& twist);

// Adds the impulse to the twists of both bodies.
void apply_impulse(const Contact& contact, double impulse, std::span<const InverseMass> mass,
                   std::span<Body> bodies);

// Changes the twists of the bodies, and sets approach and impulse of the contacts.
void resolve_impacts(std::span<Contact> contacts, std::span<const InverseMass> mass,
                     std::span<Body> bodies, BoxProblem& problem);

// Stops all contacts that approach, together and without throwing them back; adds to the impulses.
void stop_approaches(std::span<Contact> contacts, std::span<const InverseMass> mass,
                     std::span<Body> bodies, BoxProblem& problem);

}  // namespace mirocup::simulator
