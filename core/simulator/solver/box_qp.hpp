// SPDX-License-Identifier: MIT
//
// A convex QP with bounds: minimise 1/2 x.Ax + b.x with low <= x <= high.
//
// A is symmetric and positive semidefinite. With the gradient w = Ax + b the solution has w_i = 0
// inside the bounds, w_i >= 0 at the lower and w_i <= 0 at the upper bound: a mixed LCP (Cottle,
// Pang, Stone 1992). With low = 0 and high = infinity this is the complementarity of contacts (a
// force or a separation, never both); with finite bounds it is the grip of wheels.
//
// Method: a primal active set (Nocedal and Wright, "Numerical Optimization", 16.5). The exact
// minimum over the free unknowns is found by Cholesky factorisation. On the line to that minimum,
// the first unknown that hits a bound is held at it. At the minimum, one bound whose gradient
// points inwards is released. Every step lowers the objective, so the method ends. The
// factorisation is our own because a library may order its sums by the size of a cache, and a match
// must give the same bits everywhere.
#pragma once

#include "core/simulator/solver/regularized_qp.hpp"

#include <array>
#include <memory>

namespace mirocup::simulator::solver {

// One problem after another: reset(), then a(), b, low and high, then solve(). Construction
// allocates, solving does not. Belongs to one thread.
class BoxQp {
 public:
  BoxQp();

  // Starts a problem of `size` <= max_unknowns unknowns with A = 0, b = 0, 0 <= x < infinity.
  void reset(int size);

  int size() const { return size_; }
  double& a(int row, int column) { return a_[row * size_ + column]; }
  double a(int row, int column) const { return a_[row * size_ + column]; }
  // Adds to both halves of A; j <= i.
  void add_to_a(int i, int j, double by) {
    a(i, j) += by;
    if (i != j) a(j, i) += by;
  }
  Unknowns b, low, high;

  // Without a warm start, a large problem takes a round for each bound. If is_large(), the caller
  // may give all rows of A = J M^-1 J^T to warm_start() after reset(); solve() then starts from the
  // solution of the regularised QP with these rows.
  bool is_large() const;
  RegularizedQp& warm_start(std::span<const InverseMass> mass);

  // Solves the problem; the solution is in x. If there are several solutions, x is one of them. If
  // rows contradict each other, so that there is no solution, x is within its bounds and the
  // objective is at most that of the start.
  void solve();
  Unknowns x;

  // Returns the gradient w_i at x.
  double gradient(int i) const;

 private:
  enum class Bound : unsigned char { free, fixed };

  void cold_start();
  bool is_solved(double tolerance) const;
  void apply_warm_start();
  void order_all_free();  // sets order_ from bound_; nothing of it is factorised
  void drop_fixed();      // removes the fixed unknowns from order_
  void factorise();       // factorises the unknowns of order_ behind factorised_
  void solve_free();      // sets target_: the minimum over the free unknowns
  bool step_to_target();  // true if no bound was in the way
  void minimise_over_free();
  int most_violating(double tolerance) const;
  void release(int i);

  int size_ = 0;
  // Rows of size_ entries. Allocated for the largest problem but not cleared: most is never used.
  std::unique_ptr<double[]> a_;
  std::unique_ptr<double[]> factor_;  // row i of the factor belongs to unknown i
  Unknowns target_, rhs_, pivot_;
  std::array<Bound, max_unknowns> bound_;
  std::array<bool, max_unknowns> banned_;  // bounds that are no longer released
  std::array<int, max_unknowns> order_;    // the free unknowns, in the order of the factorisation
  int order_count_ = 0;
  int factorised_ = 0;  // for how many first unknowns of order_ the rows of the factor are valid

  RegularizedQp warm_start_qp_;  // used if it has all rows of the problem
};

}  // namespace mirocup::simulator::solver
