// SPDX-License-Identifier: MIT
//
// Linear equations with three unknowns for each body, a twist, and a symmetric, positive definite
// matrix that couples only bodies with a common row. They are eliminated body by body, each time the
// one with the fewest others left beside it: in a heap, where nobody touches more than a few, this
// costs hardly more than there are bodies.
#pragma once

#include "core/simulator/solver/constraint_row.hpp"

#include <array>
#include <span>
#include <vector>

namespace mirocup::simulator::solver {

using BodyVector = std::array<Vec3, max_bodies>;  // of the bodies that there are

class BlockCholesky {
 public:
  // Allocates; nothing else does.
  BlockCholesky();

  // Starts with the matrix of these bodies' masses. Where an inverse is zero the unknown is zero.
  void reset(const BodySet& bodies, std::span<const InverseMass> mass);
  // Adds weight * row' row.
  void add(const ConstraintRow& row, double weight);

  // Of the matrix, in its place; then solve() may be called for any number of right sides.
  void factorise();
  // The right side becomes the solution.
  void solve(BodyVector& rhs) const;

 private:
  using Block = std::array<Vec3, 3>;  // rows, then columns
  // The rows of a body when it is eliminated: the columns of its own, then of each of the `others`.
  struct Front {
    Block own;
    Vec3 inverse_pivot;
    unsigned long others;
    std::array<Block, max_bodies> off_diagonal;
  };

  Block& block(int high, int low) { return blocks_[high * max_bodies + low]; }
  void couple(int body, unsigned long others);
  void detach(int body);
  void assemble_front(int body, unsigned long others);
  void eliminate(int body);

  std::vector<Block> blocks_;  // rows of the higher body, columns of the lower
  // Of each body that is left, with which others that are left, one bit each; and how many.
  std::array<unsigned long, max_bodies> coupled_;
  std::array<int, max_bodies> coupled_count_;
  std::vector<Front> fronts_;  // of each body
  unsigned long bodies_ = 0;
  std::array<int, max_bodies> order_;
  int count_ = 0;
};

}  // namespace mirocup::simulator::solver
