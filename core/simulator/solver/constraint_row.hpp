// SPDX-License-Identifier: MIT
//
// Rows of the contact Jacobian J, of one body or two, and inverse masses: the parts of which every
// problem of the solvers is made (Catto 2005, "Iterative Dynamics with Temporal Coherence").
//
// The room solver uses model, and below it base, field and geometry. It knows nothing of contacts:
// its problems are given as rows, masses and bounds.
#pragma once

#include "core/simulator/model/body_pair.hpp"
#include "core/simulator/model/state.hpp"

#include <array>

namespace mirocup::simulator::solver {

// The capacity of one problem, in unknowns: contact points, tangents of contacts with friction, and
// wheels. The contact graph of n convex bodies in the plane is planar, so fewer than 3 n pairs of
// bodies touch (Euler), with two contact points at most; each robot adds the row of its wheels. The
// rest is left for contacts with obstacles and for tangents.
inline constexpr int max_unknowns = 8 * (max_bodies + 1);
static_assert(max_unknowns >= 2 * 3 * max_bodies + max_robots);

// One number for each unknown of a problem; those beyond its size are not used.
using Unknowns = std::array<double, max_unknowns>;

// The diagonal of a body's inverse mass matrix M^-1: 1/M, 1/M (1/kg) and 1/I (1/(kg m^2)). An entry
// is zero if its velocity cannot change, like the lateral velocity of wheels of infinite grip.
struct InverseMass {
  double forward = 0.0;
  double left = 0.0;
  double omega = 0.0;
};

// Three numbers of one body, one for each component of its twist: forward, left, omega.
using Vec3 = std::array<double, 3>;

// One body's part of a row of J: its share of the row's rate is row . twist.
using JacobianRow = Vec3;

// Returns row . twist.
inline double along(const JacobianRow& row, const Twist& v) {
  return row[0] * v.forward + row[1] * v.left + row[2] * v.omega;
}

// A row of J. Its rate is on_a . twist of a + on_b . twist of b; an impulse x along it changes the
// twist of a by x M_a^-1 on_a, and the twist of b by x M_b^-1 on_b.
struct ConstraintRow {
  int a = no_body;  // always a body
  int b = no_body;  // no_body: the row has one body only; on_b is not read then
  JacobianRow on_a{};
  JacobianRow on_b{};
};

// Returns the row of the rate row_a . twist of a - row_b . twist of b. One of a and b may be
// no_body, an obstacle: its part is ignored.
inline ConstraintRow difference_row(int a, int b, const JacobianRow& row_a,
                                    const JacobianRow& row_b) {
  const JacobianRow on_b{-row_b[0], -row_b[1], -row_b[2]};
  if (a == no_body) return {.a = b, .b = no_body, .on_a = on_b, .on_b = {}};
  return {.a = a, .b = b, .on_a = row_a, .on_b = on_b};
}

}  // namespace mirocup::simulator::solver
