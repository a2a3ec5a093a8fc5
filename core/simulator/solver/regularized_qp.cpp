// SPDX-License-Identifier: MIT
#include "core/simulator/solver/regularized_qp.hpp"

#include "core/base/math.hpp"

#include <algorithm>
#include <cmath>

namespace mirocup::simulator {

namespace {

// D as a share of A's diagonal.
constexpr double softness = 1e-5;

// Rounds, few of which are needed; and of one, how many halves of a step are tried for whether they
// lower the function by this share of what its slope promised, as far as rounding lets see, where the
// first bound is nearer than this share of the step.
constexpr int most_soft_rounds = 40;
constexpr int most_shortenings = 4;
constexpr double near_bound = 0.1;
constexpr double kept_promise = 0.1;
constexpr double unseen = 1e-14;
// Rounding could leave what reaches its bound a hair inside it, for ever.
constexpr double past_rounding = 1.0 + 1e-12;

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

double give_of(const JacobianRow& row, const InverseMass& m) {
  return row[0] * row[0] * m.forward + row[1] * row[1] * m.left + row[2] * row[2] * m.turn;
}

}  // namespace

void SoftProblem::reset(std::span<const InverseMass> mass) {
  std::copy(mass.begin(), mass.end(), mass_.begin());
  size_ = 0;
  bodies_.reset();
  system_fits_ = rates_fit_ = false;
}

void SoftProblem::add(const ConstraintRow& row) {
  const int i = size_++;
  rows_[i] = row;
  give_[i] = give_of(row.on_a, mass_[row.a]);
  bodies_.set(row.a);
  if (row.b != no_body) {
    give_[i] += give_of(row.on_b, mass_[row.b]);
    bodies_.set(row.b);
  }
  x[i] = b[i] = low[i] = 0.0;
  high[i] = infinity;
  bound_[i] = Bound::fixed;
  system_fits_ = rates_fit_ = false;
}

bool SoftProblem::solve(double close) {
  double scale = 0.0;
  for (int i = 0; i < size_; ++i) {
    scale = std::max(scale, std::abs(b[i]));
    centre_[i] = x[i] = std::clamp(x[i], low[i], high[i]);
  }
  look_at_value();
  for (int round = 0; round < most_soft_rounds; ++round) {
    if (hold_at_bounds(close * scale)) return true;
    find_direction();
    std::copy_n(x.begin(), size_, begin_.begin());
    std::copy_n(slope_.begin(), size_, begin_slope_.begin());
    if (!go_down()) return false;
  }
  return false;
}

// The function at x, and what it changes with each unknown.
void SoftProblem::look_at_value() {
  if (!rates_fit_ || !std::equal(x.begin(), x.begin() + size_, x_of_rates_.begin())) find_rates();
  double value = 0.0;
  for (int i = 0; i < size_; ++i) {
    const double ax = rates_[i];
    const double off = x[i] - centre_[i];
    const double pull = softness * give_[i] * off;
    value += x[i] * (0.5 * ax + b[i]) + 0.5 * pull * off;
    slope_[i] = ax + b[i] + pull;
  }
  value_ = value;
}

// A x. Who is solved anew for another b begins where it was looked at last.
void SoftProblem::find_rates() {
  stand_still();
  for (int i = 0; i < size_; ++i) {
    if (x[i] != 0.0) add_to(moved_, rows_[i], x[i]);
  }
  for_each_body(bodies_, [this](int k) {
    moved_[k][0] *= mass_[k].forward;
    moved_[k][1] *= mass_[k].left;
    moved_[k][2] *= mass_[k].turn;
  });
  for (int i = 0; i < size_; ++i) rates_[i] = rate(rows_[i], moved_);
  std::copy_n(x.begin(), size_, x_of_rates_.begin());
  rates_fit_ = true;
}

void SoftProblem::stand_still() {
  for_each_body(bodies_, [this](int k) { moved_[k] = {}; });
}

void SoftProblem::hold(int i, Bound bound) {
  system_fits_ = system_fits_ && bound_[i] == bound;
  bound_[i] = bound;
}

// What is pulled out of its bounds stays there; true if nothing else is pulled anywhere.
bool SoftProblem::hold_at_bounds(double tolerance) {
  bool solved = true;
  for (int i = 0; i < size_; ++i) {
    const bool is_given = low[i] == high[i] || give_[i] == 0.0;
    const bool is_held = is_given || (x[i] <= low[i] && slope_[i] >= -tolerance) ||
                         (x[i] >= high[i] && slope_[i] <= tolerance);
    hold(i, is_held ? Bound::fixed : Bound::free);
    solved = solved && (is_held || std::abs(slope_[i]) <= tolerance);
  }
  return solved;
}

// Newton's step of the free unknowns. Those that it would push out of the bounds where they are are
// held, too.
void SoftProblem::find_direction() {
  bool goes_out = true;
  while (goes_out) {
    goes_out = false;
    if (!system_fits_) set_up_system();
    stand_still();
    for (int i = 0; i < size_; ++i) {
      if (bound_[i] == Bound::free) add_to(moved_, rows_[i], -slope_[i] / (softness * give_[i]));
    }
    system_.solve(moved_);
    for (int i = 0; i < size_; ++i) {
      if (bound_[i] != Bound::free) continue;
      direction_[i] = -(slope_[i] + rate(rows_[i], moved_)) / (softness * give_[i]);
      const bool outwards =
          (x[i] <= low[i] && direction_[i] < 0.0) || (x[i] >= high[i] && direction_[i] > 0.0);
      if (!outwards) continue;
      hold(i, Bound::fixed);
      goes_out = true;
    }
  }
}

void SoftProblem::set_up_system() {
  system_.reset(bodies_, mass_);
  for (int i = 0; i < size_; ++i) {
    if (bound_[i] == Bound::free) system_.add(rows_[i], 1.0 / (softness * give_[i]));
  }
  system_.factorise();
  system_fits_ = true;
}

// Far in that direction, cut off at the bounds, if that lowers the function as promised; else to the
// first bound, up to where it always goes down. Where that is near, less far is tried before. False if
// not even that can be seen.
bool SoftProblem::go_down() {
  const double old_value = value_;
  const double first_bound = part_to_first_bound();
  double part = 1.0;
  for (int halved = 0; halved < most_shortenings; ++halved, part *= 0.5) {
    if (halved > 0 && first_bound >= near_bound) break;
    const double promised = try_part(part);
    if (value_ <= old_value + kept_promise * promised + unseen * std::abs(old_value)) return true;
  }
  try_part(first_bound);
  return value_ <= old_value + unseen * std::abs(old_value);
}

double SoftProblem::part_to_first_bound() const {
  double part = 1.0;
  for (int i = 0; i < size_; ++i) {
    if (bound_[i] != Bound::free || direction_[i] == 0.0) continue;
    const double limit = direction_[i] < 0.0 ? low[i] : high[i];
    part = std::min(part, past_rounding * (limit - begin_[i]) / direction_[i]);
  }
  return part;
}

// x, value and slope after that part of the step; returns what the slope before promised of it.
double SoftProblem::try_part(double part) {
  double promised = 0.0;
  for (int i = 0; i < size_; ++i) {
    if (bound_[i] != Bound::free) continue;
    x[i] = std::clamp(begin_[i] + part * direction_[i], low[i], high[i]);
    promised += begin_slope_[i] * (x[i] - begin_[i]);
  }
  look_at_value();
  return promised;
}

}  // namespace mirocup::simulator
