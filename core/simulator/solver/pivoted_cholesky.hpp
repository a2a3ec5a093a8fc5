// SPDX-License-Identifier: MIT
//
// A pivoted, rank-revealing Cholesky factorisation for symmetric linear equations of which some may
// follow from others (Higham 1990, "Analysis of the Cholesky Decomposition of a Semi-definite
// Matrix"). Redundant equations are put at the end of the order and dropped.
#pragma once

#include "core/simulator/solver/constraint_row.hpp"

#include <array>
#include <memory>

namespace mirocup::simulator::solver {

// The equations of one matrix: reset(), a(), factorise(), then solve() for any number of right-hand
// sides. Kept and reused; belongs to one thread.
class PivotedCholesky {
 public:
  PivotedCholesky();  // allocates; nothing else does

  // Starts with n <= max_unknowns equations and a matrix of zeros.
  void reset(int n);

  // Returns an entry of the matrix, in any unit. The matrix must be positive semidefinite; only its
  // lower half, j <= i, is read.
  double& a(int i, int j) { return a_[i * size_ + j]; }
  void add_to_a(int i, int j, double by) { a(i, j) += by; }

  // Factorises the matrix. Equations that are clearly independent of those before keep their order;
  // the others come behind them, the largest pivot first.
  void factorise();

  // Replaces rhs by the solution. The unknowns of redundant equations are zero.
  void solve(std::array<double, max_unknowns>& rhs) const;

  // True if equation i follows from the others. Valid after factorise().
  bool is_redundant(int i) const { return redundant_[i]; }

 private:
  void eliminate(int place, int taken);
  void pack();

  int size_ = 0;
  // Rows of size_ entries. Allocated for the largest problem but not cleared: most is never used.
  std::unique_ptr<double[]> a_;
  std::unique_ptr<double[]> factor_;     // row i belongs to equation i
  std::unique_ptr<double[]> packed_;     // the rows in the order of elimination, without gaps
  std::array<int, max_unknowns> order_;  // of elimination
  std::array<double, max_unknowns> pivot_;
  std::array<bool, max_unknowns> redundant_;
};

}  // namespace mirocup::simulator::solver
