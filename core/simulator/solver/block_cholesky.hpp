// SPDX-License-Identifier: MIT
//
// A block-sparse LDL^T factorisation in minimum-degree order (George and Liu 1981, "Computer
// Solution of Large Sparse Positive Definite Systems").
//
// The unknowns are one twist for each body. The matrix is symmetric and positive definite and
// couples only bodies with a common row. Bodies are eliminated one by one, each time the body that
// is coupled with the fewest of the remaining bodies. In a heap, where a body touches only a few
// others, the cost grows hardly faster than the number of bodies.
#pragma once

#include "core/simulator/solver/constraint_row.hpp"

#include <array>
#include <span>
#include <vector>

namespace mirocup::simulator::solver {

// One twist or right-hand side for each body, by its index; only the bodies of a system are used.
using BodyVector = std::array<Vec3, max_bodies>;

// The system (M + sum of weight row^T row) u = rhs: reset(), add() for each row, factorise(), then
// solve() for any number of right-hand sides. Belongs to one thread.
class BlockCholesky {
 public:
  BlockCholesky();  // allocates; nothing else does

  // Starts a system with the mass matrix M of these bodies. `mass` has an entry for each index up
  // to the largest body. Where an inverse mass is zero, the unknown is zero.
  void reset(const BodySet& bodies, std::span<const InverseMass> mass);
  // Adds weight row^T row. The bodies of the row must be in the system.
  void add(const ConstraintRow& row, double weight);

  // Factorises the matrix in place.
  void factorise();
  // Replaces the right-hand side by the solution. The matrix must be factorised.
  void solve(BodyVector& rhs) const;

 private:
  using Block = std::array<Vec3, 3>;  // [row][column]
  using BodyMask = unsigned long;     // a bit for each body: cheaper to change than a BodySet
  static_assert(max_bodies <= 8 * sizeof(BodyMask));

  // The three rows of a body at its elimination: an upper triangle of its own columns, then a block
  // for each body in `others`, with which it is coupled, in increasing order of their indices.
  struct Front {
    Block own;
    Vec3 inverse_pivot;  // zero for an infinite pivot, whose unknown is then zero
    BodyMask others;
    std::array<Block, max_bodies> off_diagonal;
  };

  Block& block(int high, int low) { return blocks_[high * max_bodies + low]; }
  void couple(int body, BodyMask others);
  void detach(int body);
  void assemble_front(int body, BodyMask others);
  void eliminate(int body);

  std::vector<Block> blocks_;  // rows of the higher body, columns of the lower
  // For each body not yet eliminated: the other such bodies that it is coupled with, and their
  // number, its degree.
  std::array<BodyMask, max_bodies> coupled_;
  std::array<int, max_bodies> coupled_count_;
  std::vector<Front> fronts_;  // by body
  BodyMask bodies_ = 0;
  std::array<int, max_bodies> order_;  // of elimination
  int count_ = 0;                      // bodies in order_
};

}  // namespace mirocup::simulator::solver
