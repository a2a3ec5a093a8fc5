// SPDX-License-Identifier: MIT
#include "core/simulator/solver/box_qp.hpp"

#include "core/base/math.hpp"

#include <algorithm>
#include <cmath>

namespace mirocup::simulator::solver {

namespace {
// A pivot smaller than this against its diagonal says that the unknown depends on the others: two
// contacts that push the same thing the same way. It is given this much give of its own: where the
// others leave it open, it hardly moves; where they contradict it, it goes to its bound.
constexpr double min_pivot = 1e-10;

// What counts as nothing, as a share of the largest |b|. Where rows nearly contradict each other,
// rounding can release bounds in circles: after so many, more counts as nothing with each.
constexpr double gradient_tolerance = 1e-14;
constexpr int patient_releases = 8;
constexpr double tolerance_growth = 4.0;
constexpr double max_tolerance = 1e-6;
constexpr int max_releases = 64;

// A problem of so many unknowns, six robots around the ball have fewer, is large.
constexpr int warm_start_size = 32;

}  // namespace

BoxQp::BoxQp()
    : a_(std::make_unique_for_overwrite<double[]>(max_unknowns * max_unknowns)),
      factor_(std::make_unique_for_overwrite<double[]>(max_unknowns * max_unknowns)) {}

void BoxQp::reset(int size) {
  size_ = size;
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

// Already the solution, without any step?
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

// What comes before the first of them in the factorisation is as it was.
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

// Each time the unknown with the largest pivot left comes next, so that those that nearly depend on
// others come last. Otherwise what rounding leaves of a small pivot would be taken for one, and
// divided by, again and again.
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
    row[n] = std::sqrt(std::max(pivot_[i], min_pivot * a(i, i)));
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
  const int n = order_count_;
  for (int k = 0; k < n; ++k) {
    double sum = -gradient(order_[k]);
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

// All are tried together first; those that would go the wrong way stop where they are. Most contacts
// of a heap press, so this takes fewer rounds than to begin with none.
void BoxQp::cold_start() {
  for (int i = 0; i < size_; ++i) {
    x[i] = std::clamp(0.0, low[i], high[i]);
    bound_[i] = low[i] < high[i] ? Bound::free : Bound::fixed;
  }
}

bool BoxQp::is_large() const {
  return size_ >= warm_start_size;
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

void BoxQp::solve() {
  cold_start();
  std::fill_n(banned_.begin(), size_, false);
  double scale = 0.0;
  for (int i = 0; i < size_; ++i) scale = std::max(scale, std::abs(b[i]));
  double tolerance = gradient_tolerance * scale;
  if (is_solved(tolerance)) return;
  apply_warm_start();
  order_all_free();

  // Each round releases one bound.
  for (int round = 0; round < max_releases; ++round) {
    do {
      solve_free();
    } while (!step_to_target());

    if (round >= patient_releases) {
      tolerance = std::min(tolerance * tolerance_growth, max_tolerance * scale);
    }
    const int released = most_violating(tolerance);
    if (released < 0) return;
    bound_[released] = Bound::free;
    order_all_free();
    solve_free();
    // Rounding can turn a release against its own bound; then it was no violation.
    const bool inwards = x[released] <= low[released] ? target_[released] > x[released]
                                                      : target_[released] < x[released];
    if (!inwards) {
      bound_[released] = Bound::fixed;
      banned_[released] = true;
      drop_fixed();
    }
  }
}

}  // namespace mirocup::simulator::solver
