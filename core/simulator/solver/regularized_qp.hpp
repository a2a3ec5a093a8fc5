// SPDX-License-Identifier: MIT
//
// The regularised QP with bounds, solved by Newton's method in the space of the bodies: the
// impulses of many contacts at once.
//
// The problem: minimise 1/2 x.Ax + b.x + 1/2 (x - c).D(x - c) with low <= x <= high, where A = J
// M^-1 J^T of the rows, D is a small share of A's diagonal, and the prox centre c is the x at which
// solve() starts (Parikh and Boyd 2014, "Proximal Algorithms"). D acts as a compliance of each
// contact: it makes the solution unique, however redundant the contacts are. It also pulls the
// solution towards c. A problem that is solved repeatedly starts from its last solution, so this
// pull vanishes.
//
// The method: a projected Newton method (Bertsekas 1982) with a line search. A round has three
// phases.
// 1. Active set: unknowns at a bound whose gradient points outwards are held.
// 2. Newton's direction d of the free unknowns, (A + D) d = r. With the twists u that d gives the
//    bodies this becomes (M + J^T D^-1 J) u = J^T D^-1 r, d = D^-1 (r - J u), over the free rows.
//    This is cheaper: bodies are fewer than contacts, and only bodies that touch are coupled. Bound
//    pruning: unknowns that d would push out of their bounds are also held; d is computed again.
// 3. Armijo line search along d, projected onto the bounds. The objective falls in every round, so
//    no bound is exchanged in circles.
#pragma once

#include "core/simulator/solver/block_cholesky.hpp"

#include <array>
#include <span>

namespace mirocup::simulator::solver {

// One problem after another: reset(), add() for each row, then b, low, high and x, then solve(); b,
// low, high and x may then be changed and solve() repeated. Construction allocates, solving does
// not. Belongs to one thread.
class RegularizedQp {
 public:
  // Starts a problem without unknowns. `mass` has an entry for each body, by index, that rows will
  // use; at most max_bodies. It is copied.
  void reset(std::span<const InverseMass> mass);
  // Adds the unknown of a row, with x = 0, b = 0 and 0 <= x < infinity. At most max_unknowns.
  void add(const ConstraintRow& row);

  int size() const { return size_; }
  Unknowns b, low, high;

  // Solves the problem from x as it stands, the warm start: the nearer x is to the solution, the
  // cheaper. `gradient_tolerance` is the gradient that may remain, as a share of the largest |b|.
  // Returns true if x is the solution. Otherwise x is within its bounds, and its objective is not
  // above that of the start.
  bool solve(double gradient_tolerance = 1e-10);
  Unknowns x;

 private:
  enum class Bound : unsigned char { free, fixed };

  void evaluate();        // value_ and gradient_ at x
  void evaluate_rates();  // rates_ at x
  void clear_velocities();
  bool update_active_set(double tolerance);
  void set_bound(int i, Bound bound);
  void find_newton_direction();
  void solve_newton_system();
  bool hold_outward_directions();
  void assemble_system();
  bool line_search();
  double fraction_to_first_bound() const;
  double try_fraction(double fraction);

  int size_ = 0;
  std::array<InverseMass, max_bodies> mass_;
  BodySet bodies_;  // of all rows
  std::array<ConstraintRow, max_unknowns> rows_;
  Unknowns inverse_effective_mass_;  // of each row: the diagonal of A
  std::array<Bound, max_unknowns> bound_;
  Unknowns prox_centre_;

  // The objective, its gradient and the rates at x.
  double value_ = 0.0;
  Unknowns gradient_;
  Unknowns rates_, x_at_rates_;  // A x, and the x for which it holds
  bool rates_current_ = false;   // the rows have not changed since `rates_`

  // The data of one round: x and its gradient at the start, and Newton's direction.
  Unknowns x_at_start_, gradient_at_start_, direction_;

  BodyVector velocities_;  // scratch: twists of the bodies
  BlockCholesky system_;
  bool system_current_ = false;  // rows and free unknowns have not changed since it was factorised
};

}  // namespace mirocup::simulator::solver
