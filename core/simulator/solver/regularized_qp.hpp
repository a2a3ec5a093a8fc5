// SPDX-License-Identifier: MIT
//
// The impulses of many contacts at once, softly: minimise 1/2 x.Ax + b.x + 1/2 (x - c).D(x - c) with
// low <= x <= high, where A = J M^-1 J' of the rows, D is a small part of A's diagonal and c is where
// x began. D leaves nothing open, however redundant the contacts are. It pulls to c; for what is
// solved anew until it fits, x begins where it ended, and the pull falls away.
//
// Method: Newton's, with steps that are cut off at the bounds and shortened until the function goes
// down, so no bound is exchanged in circles. Each step is sought as the twists that it gives the
// bodies, (M + J' D^-1 J) u = J' D^-1 r over the free rows: there are fewer of those than of contacts,
// and only bodies that touch are coupled.
#pragma once

#include "core/simulator/solver/block_cholesky.hpp"

#include <array>
#include <span>

namespace mirocup::simulator::solver {

// Kept and reused: making one allocates, solving does not.
class RegularizedQp {
 public:
  // Starts without unknowns. The masses of all bodies that rows will be of.
  void reset(std::span<const InverseMass> mass);
  // One more unknown, with x = 0, b = 0 and 0 <= x < infinity.
  void add(const ConstraintRow& row);

  int size() const { return size_; }
  Unknowns b, low, high;

  // From x as it stands: the nearer that is, the closer to it the solution and the cheaper. `close` is
  // the slope that may be left, as a share of the largest |b|. False if x is not quite the solution: it
  // is within its bounds, and no worse than where it began.
  bool solve(double close = 1e-10);
  Unknowns x;

 private:
  enum class Bound : unsigned char { free, fixed };

  void evaluate();
  void evaluate_rates();
  void clear_velocities();
  bool update_active_set(double tolerance);
  void set_bound(int i, Bound bound);
  void find_newton_direction();
  void assemble_system();
  bool line_search();
  double fraction_to_first_bound() const;
  double try_fraction(double part);

  int size_ = 0;
  std::array<InverseMass, max_bodies> mass_;
  BodySet bodies_;  // of any row
  std::array<ConstraintRow, max_unknowns> rows_;
  Unknowns inverse_effective_mass_;  // of each row, the diagonal of A
  std::array<Bound, max_unknowns> bound_;
  Unknowns prox_centre_, direction_;
  Unknowns slope_;
  double value_ = 0.0;
  Unknowns rates_, x_at_rates_;   // A x, and of which x
  bool rates_current_ = false;    // the rows are as they were then
  Unknowns begin_, begin_slope_;  // of a round
  BodyVector velocities_;
  BlockCholesky system_;
  bool system_current_ = false;  // the rows and the free ones as they are
};

}  // namespace mirocup::simulator::solver
