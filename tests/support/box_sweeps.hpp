// SPDX-License-Identifier: MIT
//
// The tests' own solver of the mixed LCP: low <= x <= high; Ax + b = 0 where x is between its
// bounds, >= 0 at the lower, <= 0 at the upper one. It uses projected Gauss-Seidel, which is simple
// enough to trust. For speed it solves directly for the unknowns between their bounds, and takes
// that solution if it satisfies the conditions.
#pragma once

#include <Eigen/Core>

namespace mirocup::test_support {

struct BoxConditions {
  Eigen::MatrixXd a;  // its diagonal is positive
  Eigen::VectorXd b, low, high;
};

// Returns the largest violation of the conditions by x, in units of b.
double violation(const BoxConditions& problem, const Eigen::VectorXd& x);

// Improves x until it satisfies the conditions up to rounding, or no longer gets better.
void solve_by_sweeps(const BoxConditions& problem, Eigen::VectorXd& x);

}  // namespace mirocup::test_support
