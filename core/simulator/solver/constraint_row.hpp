// SPDX-License-Identifier: MIT
//
// What impulses act along, and on which masses: rows of the contact Jacobian, of one body or two.
#pragma once

#include "core/simulator/model/body_pair.hpp"
#include "core/simulator/model/state.hpp"

#include <array>

namespace mirocup::simulator {

// Contacts, tangents and wheels of one problem.
inline constexpr int max_unknowns = 192;
using Unknowns = std::array<double, max_unknowns>;

// What a unit impulse along each generalised velocity of a body changes: 1/M, 1/M, 1/I; zero where
// wheels of infinite grip hold.
struct InverseMass {
  double forward = 0.0;
  double left = 0.0;
  double turn = 0.0;
};

// One row of the contact Jacobian, of one body: its share of a rate is row . twist.
using JacobianRow = std::array<double, 3>;

inline double along(const JacobianRow& row, const Twist& v) {
  return row[0] * v.forward + row[1] * v.left + row[2] * v.turn;
}

// All of it: the rate is on_a . twist of a plus on_b . twist of b.
struct CoupledRow {
  int a = no_body;  // always a body
  int b = no_body;
  JacobianRow on_a{};
  JacobianRow on_b{};
};

}  // namespace mirocup::simulator
