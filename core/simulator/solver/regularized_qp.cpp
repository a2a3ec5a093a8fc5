// SPDX-License-Identifier: MIT
#include "core/simulator/solver/regularized_qp.hpp"

#include "core/base/math.hpp"

#include <algorithm>
#include <cmath>

namespace mirocup::simulator::solver {

namespace {

// D as a share of A's diagonal.
constexpr double regularization = 1e-5;

// Rounds, few of which are needed; and of one, how many halves of a step are tried for whether they
// lower the function by this share of what its slope promised, as far as rounding lets see, where the
// first bound is nearer than this share of the step.
constexpr int max_newton_rounds = 40;
constexpr int max_backtracks = 4;
constexpr double near_bound = 0.1;
constexpr double armijo_fraction = 0.1;
constexpr double value_round_off = 1e-14;
// Rounding could leave what reaches its bound a hair inside it, for ever.
constexpr double bound_round_off = 1.0 + 1e-12;

double rate(const ConstraintRow& row, const BodyVector& v) {
  const JacobianRow& a = v[row.a];
  const double of_a = row.on_a[0] * a[0] + row.on_a[1] * a[1] + row.on_a[2] * a[2];
  if (row.b == no_body) return of_a;
  const JacobianRow& b = v[row.b];
  return of_a + (row.on_b[0] * b[0] + row.on_b[1] * b[1] + row.on_b[2] * b[2]);
}

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
  std::copy(mass.begin(), mass.end(), mass_.begin());
  size_ = 0;
  bodies_.reset();
  system_current_ = rates_current_ = false;
}

void RegularizedQp::add(const ConstraintRow& row) {
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

bool RegularizedQp::solve(double close) {
  double scale = 0.0;
  for (int i = 0; i < size_; ++i) {
    scale = std::max(scale, std::abs(b[i]));
    prox_centre_[i] = x[i] = std::clamp(x[i], low[i], high[i]);
  }
  evaluate();
  for (int round = 0; round < max_newton_rounds; ++round) {
    if (update_active_set(close * scale)) return true;
    find_newton_direction();
    std::copy_n(x.begin(), size_, begin_.begin());
    std::copy_n(slope_.begin(), size_, begin_slope_.begin());
    if (!line_search()) return false;
  }
  return false;
}

// The function at x, and what it changes with each unknown.
void RegularizedQp::evaluate() {
  if (!rates_current_ || !std::equal(x.begin(), x.begin() + size_, x_at_rates_.begin()))
    evaluate_rates();
  double value = 0.0;
  for (int i = 0; i < size_; ++i) {
    const double ax = rates_[i];
    const double off = x[i] - prox_centre_[i];
    const double pull = regularization * inverse_effective_mass_[i] * off;
    value += x[i] * (0.5 * ax + b[i]) + 0.5 * pull * off;
    slope_[i] = ax + b[i] + pull;
  }
  value_ = value;
}

// A x. Who is solved anew for another b begins where it was looked at last.
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

// What is pulled out of its bounds stays there; true if nothing else is pulled anywhere.
bool RegularizedQp::update_active_set(double tolerance) {
  bool solved = true;
  for (int i = 0; i < size_; ++i) {
    const bool is_given = low[i] == high[i] || inverse_effective_mass_[i] == 0.0;
    const bool is_held = is_given || (x[i] <= low[i] && slope_[i] >= -tolerance) ||
                         (x[i] >= high[i] && slope_[i] <= tolerance);
    set_bound(i, is_held ? Bound::fixed : Bound::free);
    solved = solved && (is_held || std::abs(slope_[i]) <= tolerance);
  }
  return solved;
}

// Newton's step of the free unknowns. Those that it would push out of the bounds where they are are
// held, too.
void RegularizedQp::find_newton_direction() {
  bool goes_out = true;
  while (goes_out) {
    goes_out = false;
    if (!system_current_) assemble_system();
    clear_velocities();
    for (int i = 0; i < size_; ++i) {
      if (bound_[i] == Bound::free)
        add_to(velocities_, rows_[i], -slope_[i] / (regularization * inverse_effective_mass_[i]));
    }
    system_.solve(velocities_);
    for (int i = 0; i < size_; ++i) {
      if (bound_[i] != Bound::free) continue;
      direction_[i] = -(slope_[i] + rate(rows_[i], velocities_)) /
                      (regularization * inverse_effective_mass_[i]);
      const bool outwards =
          (x[i] <= low[i] && direction_[i] < 0.0) || (x[i] >= high[i] && direction_[i] > 0.0);
      if (!outwards) continue;
      set_bound(i, Bound::fixed);
      goes_out = true;
    }
  }
}

void RegularizedQp::assemble_system() {
  system_.reset(bodies_, mass_);
  for (int i = 0; i < size_; ++i) {
    if (bound_[i] == Bound::free)
      system_.add(rows_[i], 1.0 / (regularization * inverse_effective_mass_[i]));
  }
  system_.factorise();
  system_current_ = true;
}

// Far in that direction, cut off at the bounds, if that lowers the function as promised; else to the
// first bound, up to where it always goes down. Where that is near, less far is tried before. False if
// not even that can be seen.
bool RegularizedQp::line_search() {
  const double old_value = value_;
  const double first_bound = fraction_to_first_bound();
  double part = 1.0;
  for (int halved = 0; halved < max_backtracks; ++halved, part *= 0.5) {
    if (halved > 0 && first_bound >= near_bound) break;
    const double promised = try_fraction(part);
    if (value_ <= old_value + armijo_fraction * promised + value_round_off * std::abs(old_value))
      return true;
  }
  try_fraction(first_bound);
  return value_ <= old_value + value_round_off * std::abs(old_value);
}

double RegularizedQp::fraction_to_first_bound() const {
  double part = 1.0;
  for (int i = 0; i < size_; ++i) {
    if (bound_[i] != Bound::free || direction_[i] == 0.0) continue;
    const double limit = direction_[i] < 0.0 ? low[i] : high[i];
    part = std::min(part, bound_round_off * (limit - begin_[i]) / direction_[i]);
  }
  return part;
}

// x, value and slope after that part of the step; returns what the slope before promised of it.
double RegularizedQp::try_fraction(double part) {
  double promised = 0.0;
  for (int i = 0; i < size_; ++i) {
    if (bound_[i] != Bound::free) continue;
    x[i] = std::clamp(begin_[i] + part * direction_[i], low[i], high[i]);
    promised += begin_slope_[i] * (x[i] - begin_[i]);
  }
  evaluate();
  return promised;
}

}  // namespace mirocup::simulator::solver
