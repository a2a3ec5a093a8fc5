// SPDX-License-Identifier: MIT
#include "core/simulator/solver/box_qp.hpp"

#include "core/base/assert.hpp"
#include "core/base/math.hpp"
#include "core/simulator/model/solver_settings.hpp"

#include <algorithm>
#include <cmath>

namespace mirocup::simulator::solver {

BoxQp::BoxQp()
    : a_(std::make_unique_for_overwrite<double[]>(max_unknowns * max_unknowns)),
      factor_(std::make_unique_for_overwrite<double[]>(max_unknowns * max_unknowns)) {}

void BoxQp::reset(int size) {
  MIROCUP_ASSERT(0 <= size && size <= max_unknowns);
  size_ = size;
  spoil(b, low, high, x, target_, rhs_, pivot_, bound_, banned_, order_);
  spoil_n(factor_.get(), size * size);
  warm_start_qp_.reset({});
  std::fill_n(a_.get(), size * size, 0.0);
  std::fill_n(b.begin(), size, 0.0);
  std::fill_n(low.begin(), size, 0.0);
  std::fill_n(high.begin(), size, infinity);
}

double BoxQp::gradient(int i) const {
  double w = b[i];
  for (int j = 0; j < size_; ++j) w += a(i, j) * x[j];
  return w;
}

// True if x meets the optimality conditions.
bool BoxQp::is_solved(double tolerance) const {
  for (int i = 0; i < size_; ++i) {
    const double w = gradient(i);
    if (w < -tolerance && x[i] < high[i]) return false;
    if (w > tolerance && x[i] > low[i]) return false;
  }
  return true;
}

void BoxQp::order_all_free() {
  order_count_ = 0;
  factorised_ = 0;
  for (int i = 0; i < size_; ++i) {
    if (bound_[i] == Bound::free && a(i, i) != 0.0) order_[order_count_++] = i;
  }
}

// Drops the unknowns that are held now. The factor stays valid up to the first of them.
void BoxQp::drop_fixed() {
  int left = 0;
  for (int k = 0; k < order_count_; ++k) {
    const int i = order_[k];
    if (bound_[i] == Bound::free) {
      order_[left++] = i;
    } else {
      factorised_ = std::min(factorised_, left);
    }
  }
  order_count_ = left;
}

// The unknown with the largest remaining pivot comes next, so that those that nearly depend on
// others come last. The pivot of such an unknown is mostly rounding, and dividing by it would spoil
// all unknowns after it.
void BoxQp::factorise() {
  for (int k = factorised_; k < order_count_; ++k) {
    const int i = order_[k];
    pivot_[i] = a(i, i);
    const double* row = &factor_[i * size_];
    for (int l = 0; l < factorised_; ++l) pivot_[i] -= row[l] * row[l];
  }
  for (int n = factorised_; n < order_count_; ++n) {
    int next = n;
    for (int k = n + 1; k < order_count_; ++k) {
      if (pivot_[order_[k]] > pivot_[order_[next]]) next = k;
    }
    std::swap(order_[n], order_[next]);
    const int i = order_[n];
    double* row = &factor_[i * size_];
    row[n] = std::sqrt(std::max(pivot_[i], settings::box_qp.min_pivot * a(i, i)));
    for (int k = n + 1; k < order_count_; ++k) {
      const int j = order_[k];
      double* other = &factor_[j * size_];
      double sum = a(j, i);
      for (int l = 0; l < n; ++l) sum -= other[l] * row[l];
      other[n] = sum / row[n];
      pivot_[j] -= other[n] * other[n];
    }
  }
  factorised_ = order_count_;
}

void BoxQp::solve_free() {
  for (int i = 0; i < size_; ++i) target_[i] = x[i];
  factorise();
  const bool is_zero = std::count(x.begin(), x.begin() + size_, 0.0) == size_;  // the gradient is b
  const int n = order_count_;
  for (int k = 0; k < n; ++k) {
    double sum = is_zero ? -b[order_[k]] : -gradient(order_[k]);
    const double* row = &factor_[order_[k] * size_];
    for (int l = 0; l < k; ++l) sum -= row[l] * rhs_[l];
    rhs_[k] = sum / row[k];
  }
  for (int k = n - 1; k >= 0; --k) {
    double sum = rhs_[k];
    for (int l = k + 1; l < n; ++l) sum -= factor_[order_[l] * size_ + k] * rhs_[l];
    rhs_[k] = sum / factor_[order_[k] * size_ + k];
    target_[order_[k]] = x[order_[k]] + rhs_[k];
  }
}

// Moves x towards target_ up to the first bound, and holds all unknowns that reach a bound there.
bool BoxQp::step_to_target() {
  double fraction = 1.0;
  for (int i = 0; i < size_; ++i) {
    if (bound_[i] != Bound::free) continue;
    const double limit = target_[i] < low[i] ? low[i] : high[i];
    if (target_[i] >= low[i] && target_[i] <= high[i]) continue;
    fraction = std::min(fraction, (limit - x[i]) / (target_[i] - x[i]));
  }
  fraction = std::max(fraction, 0.0);
  bool reached = true;
  for (int i = 0; i < size_; ++i) {
    if (bound_[i] != Bound::free) continue;
    const bool outside = target_[i] < low[i] || target_[i] > high[i];
    const double limit = target_[i] < low[i] ? low[i] : high[i];
    const bool stops = outside && (limit - x[i]) / (target_[i] - x[i]) <= fraction;
    x[i] = stops ? limit : x[i] + fraction * (target_[i] - x[i]);
    if (stops) {
      bound_[i] = Bound::fixed;
      reached = false;
    }
  }
  if (!reached) drop_fixed();
  return reached;
}

// The held unknown whose gradient points inwards the most, or -1 if none exceeds the tolerance.
int BoxQp::most_violating(double tolerance) const {
  int worst = -1;
  double most = tolerance;
  for (int i = 0; i < size_; ++i) {
    if (bound_[i] == Bound::free || banned_[i] || low[i] == high[i]) continue;
    const double w = gradient(i);
    const double violation = x[i] <= low[i] ? -w : w;
    if (violation > most) {
      most = violation;
      worst = i;
    }
  }
  return worst;
}

// All unknowns are free at first, and those that would move outwards are held at their bounds. Most
// contacts of a heap press, so this takes fewer rounds than to start with none.
void BoxQp::cold_start() {
  for (int i = 0; i < size_; ++i) {
    x[i] = std::clamp(0.0, low[i], high[i]);
    bound_[i] = low[i] < high[i] ? Bound::free : Bound::fixed;
    banned_[i] = false;
  }
}

bool BoxQp::is_large() const {
  return size_ >= settings::box_qp.warm_start_size;
}

RegularizedQp& BoxQp::warm_start(std::span<const InverseMass> mass) {
  warm_start_qp_.reset(mass);
  return warm_start_qp_;
}

void BoxQp::apply_warm_start() {
  if (warm_start_qp_.size() != size_) return;
  warm_start_qp_.b = b;
  warm_start_qp_.low = low;
  warm_start_qp_.high = high;
  std::fill_n(warm_start_qp_.x.begin(), size_, 0.0);
  if (!warm_start_qp_.solve()) return;
  for (int i = 0; i < size_; ++i) {
    x[i] = warm_start_qp_.x[i];
    bound_[i] = low[i] < x[i] && x[i] < high[i] ? Bound::free : Bound::fixed;
  }
}

// Each step that does not reach the minimum holds one more unknown, so there are at most as many
// steps as free unknowns.
void BoxQp::minimise_over_free() {
  do {
    solve_free();
  } while (!step_to_target());
}

// Releases the bound of unknown i, and bans it if the release would move the unknown outwards.
//
// In exact arithmetic the minimum over the free unknowns and i lies inwards of the bound of i,
// because the gradient of i points inwards. Where i nearly depends on the free unknowns, rounding
// can turn that around. The next step would then hold i again, in circles. So a probe,
// solve_free(), computes the direction before anything moves. If it points inwards, the next
// round starts with the factor that the probe has made.
void BoxQp::release(int i) {
  bound_[i] = Bound::free;
  order_all_free();
  solve_free();
  const bool inwards = x[i] <= low[i] ? target_[i] > x[i] : target_[i] < x[i];
  if (inwards) return;
  bound_[i] = Bound::fixed;
  banned_[i] = true;
  drop_fixed();
}

void BoxQp::solve() {
  cold_start();
  double scale = 0.0;
  for (int i = 0; i < size_; ++i) scale = std::max(scale, std::abs(b[i]));
  double tolerance = settings::box_qp.gradient_tolerance * scale;
  if (is_solved(tolerance)) return;
  apply_warm_start();
  order_all_free();

  for (int round = 0; round < settings::box_qp.max_rounds; ++round) {
    minimise_over_free();
    if (round >= settings::box_qp.exact_rounds) {
      tolerance = std::min(tolerance * settings::box_qp.tolerance_growth,
                           settings::box_qp.max_gradient_tolerance * scale);
    }
    const int violating = most_violating(tolerance);
    if (violating < 0) return;
    release(violating);
  }
}

}  // namespace mirocup::simulator::solver
