// SPDX-License-Identifier: MIT
//
// Linear equations with a symmetric, positive definite matrix that is well clear of singular: no
// pivots are looked for. What may be singular goes through elimination.hpp.
#pragma once

#include <vector>

namespace mirocup::simulator {

class DefiniteSystem {
 public:
  // Allocates for that many unknowns; nothing else does.
  explicit DefiniteSystem(int most_unknowns);

  // Starts with n equations whose matrix is not set.
  void reset(int n) { size_ = n; }
  int size() const { return size_; }

  // Row k of the matrix, of which columns k .. n - 1 count.
  double* row(int k) { return &upper_[static_cast<std::size_t>(k * size_)]; }
  const double* row(int k) const { return &upper_[static_cast<std::size_t>(k * size_)]; }

  // Of the matrix, in its place; then solve() may be called for any number of right sides.
  void factorise();
  // rhs[0 .. n - 1] becomes the solution.
  void solve(double* rhs) const;

 private:
  void eliminate_one(int k);
  void eliminate_two(int k);

  int size_ = 0;
  std::vector<double> upper_;
  std::vector<double> inverse_pivot_;
};

}  // namespace mirocup::simulator
