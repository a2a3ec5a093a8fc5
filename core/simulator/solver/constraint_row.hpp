// SPDX-License-Identifier: MIT
//
// What impulses act along, and on which masses: rows of the contact Jacobian, of one body or two.
#pragma once

#include "core/simulator/model/body_pair.hpp"
#include "core/simulator/model/state.hpp"

#include <array>

namespace mirocup::simulator::solver {

// Contacts, tangents and wheels of one problem.
inline constexpr int max_unknowns = 192;
using Unknowns = std::array<double, max_unknowns>;

// What a unit impulse along each generalised velocity of a body changes: 1/M, 1/M, 1/I; zero where
// wheels of infinite grip hold.
struct InverseMass {
  double forward = 0.0;
  double left = 0.0;
  double omega = 0.0;
};

// Three numbers of one body, one for each component of its twist.
using Vec3 = std::array<double, 3>;

// One body's part of a row of the contact Jacobian: its share of the row's rate is row . twist.
using JacobianRow = Vec3;

inline double along(const JacobianRow& row, const Twist& v) {
  return row[0] * v.forward + row[1] * v.left + row[2] * v.omega;
}

// A whole row: its rate is on_a . twist of a + on_b . twist of b.
struct ConstraintRow {
  int a = no_body;  // always a body
  int b = no_body;  // no_body: the row has one body only
  JacobianRow on_a{};
  JacobianRow on_b{};
};

// The row of the rate row_a . twist of a - row_b . twist of b. One of the sides may be no_body, a wall:
// its part is ignored.
inline ConstraintRow difference_row(int a, int b, const JacobianRow& row_a,
                                    const JacobianRow& row_b) {
  const JacobianRow on_b{-row_b[0], -row_b[1], -row_b[2]};
  if (a == no_body) return {.a = b, .b = no_body, .on_a = on_b, .on_b = {}};
  return {.a = a, .b = b, .on_a = row_a, .on_b = on_b};
}

}  // namespace mirocup::simulator::solver
