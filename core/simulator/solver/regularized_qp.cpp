// SPDX-License-Identifier: MIT
#include "core/simulator/solver/regularized_qp.hpp"

#include "core/base/assert.hpp"
#include "core/base/math.hpp"
#include "core/simulator/model/solver_settings.hpp"

#include <algorithm>
#include <cmath>

namespace mirocup::simulator::solver {

namespace {

constexpr auto& tuning = settings::regularized_qp;

// J v, the entry of one row.
double rate(const ConstraintRow& row, const BodyVector& v) {
  const JacobianRow& a = v[row.a];
  const double of_a = row.on_a[0] * a[0] + row.on_a[1] * a[1] + row.on_a[2] * a[2];
  if (row.b == no_body) return of_a;
  const JacobianRow& b = v[row.b];
  return of_a + (row.on_b[0] * b[0] + row.on_b[1] * b[1] + row.on_b[2] * b[2]);
}

// Adds `by` times one row of J^T.
void add_to(BodyVector& v, const ConstraintRow& row, double by) {
  JacobianRow& a = v[row.a];
  for (int c = 0; c < 3; ++c) a[c] += by * row.on_a[c];
  if (row.b == no_body) return;
  JacobianRow& b = v[row.b];
  for (int c = 0; c < 3; ++c) b[c] += by * row.on_b[c];
}

double inverse_mass_along(const JacobianRow& row, const InverseMass& m) {
  return row[0] * row[0] * m.forward + row[1] * row[1] * m.left + row[2] * row[2] * m.omega;
}

}  // namespace

void RegularizedQp::reset(std::span<const InverseMass> mass) {
  MIROCUP_ASSERT(mass.size() <= mass_.size());
  spoil(mass_, rows_, inverse_effective_mass_, bound_, prox_centre_, value_, gradient_, rates_,
        x_at_rates_, x_at_start_, gradient_at_start_, direction_, velocities_, b, low, high, x);
  std::copy(mass.begin(), mass.end(), mass_.begin());
  size_ = 0;
  bodies_.reset();
  system_current_ = rates_current_ = false;
}

void RegularizedQp::add(const ConstraintRow& row) {
  MIROCUP_ASSERT(size_ < max_unknowns);
  const int i = size_++;
  rows_[i] = row;
  inverse_effective_mass_[i] = inverse_mass_along(row.on_a, mass_[row.a]);
  bodies_.set(row.a);
  if (row.b != no_body) {
    inverse_effective_mass_[i] += inverse_mass_along(row.on_b, mass_[row.b]);
    bodies_.set(row.b);
  }
  x[i] = b[i] = low[i] = 0.0;
  high[i] = infinity;
  bound_[i] = Bound::fixed;
  system_current_ = rates_current_ = false;
}

bool RegularizedQp::solve(double gradient_tolerance) {
  double scale = 0.0;
  for (int i = 0; i < size_; ++i) {
    scale = std::max(scale, std::abs(b[i]));
    prox_centre_[i] = x[i] = std::clamp(x[i], low[i], high[i]);
  }
  evaluate();
  for (int round = 0; round < tuning.max_newton_rounds; ++round) {
    if (update_active_set(gradient_tolerance * scale)) return true;
    find_newton_direction();
    std::copy_n(x.begin(), size_, x_at_start_.begin());
    std::copy_n(gradient_.begin(), size_, gradient_at_start_.begin());
    if (!line_search()) return false;
  }
  return false;
}

// Computes the objective and its gradient at x.
void RegularizedQp::evaluate() {
  if (!rates_current_ || !std::equal(x.begin(), x.begin() + size_, x_at_rates_.begin()))
    evaluate_rates();
  double value = 0.0;
  for (int i = 0; i < size_; ++i) {
    const double ax = rates_[i];
    const double off = x[i] - prox_centre_[i];
    const double pull = tuning.regularization * inverse_effective_mass_[i] * off;
    value += x[i] * (0.5 * ax + b[i]) + 0.5 * pull * off;
    gradient_[i] = ax + b[i] + pull;
  }
  value_ = value;
}

// Computes A x = J M^-1 J^T x. The result is kept, because a problem that is solved for another b
// starts at the x of the last evaluation.
void RegularizedQp::evaluate_rates() {
  clear_velocities();
  for (int i = 0; i < size_; ++i) {
    if (x[i] != 0.0) add_to(velocities_, rows_[i], x[i]);
  }
  for_each_body(bodies_, [this](int k) {
    velocities_[k][0] *= mass_[k].forward;
    velocities_[k][1] *= mass_[k].left;
    velocities_[k][2] *= mass_[k].omega;
  });
  for (int i = 0; i < size_; ++i) rates_[i] = rate(rows_[i], velocities_);
  std::copy_n(x.begin(), size_, x_at_rates_.begin());
  rates_current_ = true;
}

void RegularizedQp::clear_velocities() {
  for_each_body(bodies_, [this](int k) { velocities_[k] = {}; });
}

void RegularizedQp::set_bound(int i, Bound bound) {
  system_current_ = system_current_ && bound_[i] == bound;
  bound_[i] = bound;
}

// Holds the unknowns at a bound whose gradient points outwards, and frees the others. Returns true
// if the gradients of the free ones are zero: x is the solution.
bool RegularizedQp::update_active_set(double tolerance) {
  bool solved = true;
  for (int i = 0; i < size_; ++i) {
    const bool is_given = low[i] == high[i] || inverse_effective_mass_[i] == 0.0;
    const bool is_held = is_given || (x[i] <= low[i] && gradient_[i] >= -tolerance) ||
                         (x[i] >= high[i] && gradient_[i] <= tolerance);
    set_bound(i, is_held ? Bound::fixed : Bound::free);
    solved = solved && (is_held || std::abs(gradient_[i]) <= tolerance);
  }
  return solved;
}

// Each repetition holds at least one more unknown, so this ends.
void RegularizedQp::find_newton_direction() {
  do {
    solve_newton_system();
  } while (hold_outward_directions());
}

// Computes Newton's direction of the free unknowns in the space of the bodies, with r = -gradient.
void RegularizedQp::solve_newton_system() {
  if (!system_current_) assemble_system();
  clear_velocities();
  for (int i = 0; i < size_; ++i) {
    if (bound_[i] == Bound::free)
      add_to(velocities_, rows_[i],
             -gradient_[i] / (tuning.regularization * inverse_effective_mass_[i]));
  }
  system_.solve(velocities_);
  for (int i = 0; i < size_; ++i) {
    if (bound_[i] != Bound::free) continue;
    direction_[i] = -(gradient_[i] + rate(rows_[i], velocities_)) /
                    (tuning.regularization * inverse_effective_mass_[i]);
  }
}

// Bound pruning: holds the free unknowns at a bound whose direction points outwards. Returns true
// if there are any.
bool RegularizedQp::hold_outward_directions() {
  bool any = false;
  for (int i = 0; i < size_; ++i) {
    if (bound_[i] != Bound::free) continue;
    const bool outwards =
        (x[i] <= low[i] && direction_[i] < 0.0) || (x[i] >= high[i] && direction_[i] > 0.0);
    if (!outwards) continue;
    set_bound(i, Bound::fixed);
    any = true;
  }
  return any;
}

// Assembles and factorises M + J^T D^-1 J over the free rows.
void RegularizedQp::assemble_system() {
  system_.reset(bodies_, mass_);
  for (int i = 0; i < size_; ++i) {
    if (bound_[i] == Bound::free)
      system_.add(rows_[i], 1.0 / (tuning.regularization * inverse_effective_mass_[i]));
  }
  system_.factorise();
  system_current_ = true;
}

// Backtracking with Armijo's condition, on the path that is projected onto the bounds. If the
// whole step does not lower the objective enough, the step to the first bound is taken, because
// up to there the path is straight and the objective falls. Where that bound is near, such a step
// would be tiny, so shorter fractions of the projected path are tried before. Returns false if
// rounding hides even the fall up to the first bound.
bool RegularizedQp::line_search() {
  const double old_value = value_;
  const double first_bound = fraction_to_first_bound();
  double fraction = 1.0;
  for (int backtracks = 0; backtracks < tuning.max_backtracks; ++backtracks, fraction *= 0.5) {
    if (backtracks > 0 && first_bound >= tuning.near_bound) break;
    const double promised = try_fraction(fraction);
    if (value_ <= old_value + tuning.armijo_fraction * promised +
                      tuning.value_round_off * std::abs(old_value))
      return true;
  }
  try_fraction(first_bound);
  return value_ <= old_value + tuning.value_round_off * std::abs(old_value);
}

// The fraction of the step at which the first free unknown reaches its bound, at most 1.
double RegularizedQp::fraction_to_first_bound() const {
  double fraction = 1.0;
  for (int i = 0; i < size_; ++i) {
    if (bound_[i] != Bound::free || direction_[i] == 0.0) continue;
    const double limit = direction_[i] < 0.0 ? low[i] : high[i];
    fraction =
        std::min(fraction, tuning.bound_round_off * (limit - x_at_start_[i]) / direction_[i]);
  }
  return fraction;
}

// Sets x, value and gradient after a fraction of the step, projected onto the bounds. Returns the
// change of the objective that the gradient at the start promises.
double RegularizedQp::try_fraction(double fraction) {
  double promised = 0.0;
  for (int i = 0; i < size_; ++i) {
    if (bound_[i] != Bound::free) continue;
    x[i] = std::clamp(x_at_start_[i] + fraction * direction_[i], low[i], high[i]);
    promised += gradient_at_start_[i] * (x[i] - x_at_start_[i]);
  }
  evaluate();
  return promised;
}

}  // namespace mirocup::simulator::solver
