// SPDX-License-Identifier: MIT
//
// Symmetric linear equations of which some may follow from others: Cholesky's factorisation in an
// order that leaves those for the end.
#pragma once

#include "core/simulator/solver/constraint_row.hpp"

#include <array>
#include <memory>

namespace mirocup::simulator::solver {

class PivotedCholesky {
 public:
  PivotedCholesky();  // allocates; nothing else does

  // Starts with n equations and a matrix of zeros.
  void reset(int n);

  // The matrix, in any unit, positive semidefinite; the lower half, j <= i, is what counts.
  double& a(int i, int j) { return a_[i * size_ + j]; }
  void add_to_a(int i, int j, double by) { a(i, j) += by; }

  // The equations are taken in their order as long as they are clear of those before.
  void factorise();

  // rhs becomes the solution. Unknowns of equations that follow from others are zero.
  void solve(std::array<double, max_unknowns>& rhs) const;

  bool is_redundant(int i) const { return redundant_[i]; }

 private:
  void eliminate(int place, int taken);
  void pack();

  int size_ = 0;
  // Not cleared: most of it is never touched.
  std::unique_ptr<double[]> a_;
  std::unique_ptr<double[]> factor_;     // row i belongs to equation i
  std::unique_ptr<double[]> packed_;     // the same in their order, without gaps
  std::array<int, max_unknowns> order_;  // of the equations in it
  std::array<double, max_unknowns> pivot_;
  std::array<bool, max_unknowns> redundant_;
};

}  // namespace mirocup::simulator::solver
