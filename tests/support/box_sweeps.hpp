// SPDX-License-Identifier: MIT
//
// The tests' own solver of: low <= x <= high; Ax + b = 0 where x is between its bounds, >= 0 at the
// lower, <= 0 at the upper one. Projected Gauss-Seidel, which is hard to get wrong. For speed, the
// unknowns that it finds between their bounds are solved directly, and the solution is taken if it
// fits.
#pragma once

#include <Eigen/Core>

namespace mirocup::test_support {

struct BoxConditions {
  Eigen::MatrixXd a;  // its diagonal is positive
  Eigen::VectorXd b, low, high;
};

// Returns how much x violates the conditions, in units of b.
double violation(const BoxConditions& problem, const Eigen::VectorXd& x);

// Improves x until it satisfies the conditions to rounding, or no longer gets better.
void solve_by_sweeps(const BoxConditions& problem, Eigen::VectorXd& x);

}  // namespace mirocup::test_support
