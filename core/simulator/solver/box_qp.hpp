// SPDX-License-Identifier: MIT
//
// The one numerical problem behind every contact: minimise 1/2 x.Ax + b.x with low <= x <= high.
//
// A is symmetric and positive semidefinite. With w = Ax + b the solution has w_i = 0 inside the
// bounds, w_i >= 0 at the lower and w_i <= 0 at the upper bound: for low = 0, high = infinity this
// is the complementarity of contacts (force or separation, never both), for a finite box the grip
// of wheels.
//
// Method: active sets. The free unknowns are solved exactly by Cholesky; on the way to that
// solution the first unknown to hit a bound stops there; a bound that pulls the wrong way is
// released. Every step lowers the function, so it ends. The factorisation is our own because a
// library may order its sums by the size of a cache, and a match must give the same bits
// everywhere.
#pragma once

#include "core/simulator/solver/regularized_qp.hpp"

#include <array>
#include <memory>

namespace mirocup::simulator::solver {

// Kept and reused: making one allocates, solving does not.
class BoxQp {
 public:
  BoxQp();

  // Starts a problem of that size with A = 0, b = 0, 0 <= x < infinity.
  void reset(int size);

  int size() const { return size_; }
  double& a(int row, int column) { return a_[row * size_ + column]; }
  double a(int row, int column) const { return a_[row * size_ + column]; }
  // Adds to both halves; j <= i.
  void add_to_a(int i, int j, double by) {
    a(i, j) += by;
    if (i != j) a(j, i) += by;
  }
  Unknowns b, low, high;

  // Each bound costs a round. So a large problem whose rows are known, all of them, is begun where it
  // is nearly solved, after reset().
  bool is_large() const;
  RegularizedQp& warm_start(std::span<const InverseMass> mass);

  // The solution is in x; where A leaves it open, one of the solutions.
  void solve();
  Unknowns x;

  // w_i, from x as it stands.
  double gradient(int i) const;

 private:
  enum class Bound : unsigned char { free, fixed };

  void cold_start();
  bool is_solved(double tolerance) const;
  void order_all_free();  // order_ from bound_, nothing of it factorised
  void drop_fixed();      // from order_
  void factorise();       // what is not yet, of order_
  void solve_free();      // target_ from the free unknowns, the others held
  bool step_to_target();  // true if no bound was in the way
  int most_violating(double tolerance) const;
  void apply_warm_start();

  int size_ = 0;
  // Not cleared: most of it is never touched.
  std::unique_ptr<double[]> a_;
  std::unique_ptr<double[]> factor_;  // row i of the factor belongs to unknown i
  Unknowns target_, rhs_, pivot_;
  std::array<Bound, max_unknowns> bound_;
  std::array<bool, max_unknowns> banned_;
  std::array<int, max_unknowns> order_;  // the free unknowns, in the order of the factorisation
  int order_count_ = 0;
  int factorised_ = 0;  // so many of them, the first ones, have been

  RegularizedQp warm_start_qp_;  // if it has the unknowns
};

}  // namespace mirocup::simulator::solver
