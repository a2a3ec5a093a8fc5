// SPDX-License-Identifier: MIT
#include "core/simulator/complementarity.hpp"

#include "core/base/math.hpp"

#include <algorithm>
#include <cmath>

namespace mirocup::simulator {

namespace {
// A pivot smaller than this against its diagonal says that the unknown depends on the others: two
// contacts that push the same thing the same way. It is given this much give of its own: where the
// others leave it open, it hardly moves; where they contradict it, it goes to its bound.
constexpr double least_pivot = 1e-10;

// A problem of so many unknowns, six robots around the ball have fewer, is large.
constexpr int large = 32;

// What solve_softly() adds to the diagonal, as shares of it, one after the other; what it begins
// with if that is easy enough.
constexpr std::array<double, 8> softness{1e-1, 3e-2, 1e-2, 3e-3, 1e-3, 3e-4, 1e-4, 1e-5};
constexpr std::size_t usual_softness = 4;

// Rounds of solve_softly() that may exchange all wrong bounds although that does not make them
// fewer; and rounds altogether.
constexpr int patient_rounds = 1;
constexpr int most_soft_rounds = 25;

void subtract(double factor, const double* __restrict row, int count, double* __restrict from) {
  for (int i = 0; i < count; ++i) from[i] -= factor * row[i];
}
}  // namespace

BoxProblem::BoxProblem()
    : a_(max_unknowns * max_unknowns),
      upper_factor_(max_unknowns * max_unknowns),
      factor_(max_unknowns * max_unknowns) {}

void BoxProblem::reset(int size) {
  size_ = size;
  for (int i = 0; i < size; ++i) {
    std::fill_n(&a_[i * max_unknowns], size, 0.0);
    b[i] = 0.0;
    low[i] = 0.0;
    high[i] = infinity;
  }
}

double BoxProblem::gradient(int i) const {
  double w = b[i];
  for (int j = 0; j < size_; ++j) w += a(i, j) * x[j];
  return w;
}

// Already the solution, without any step?
bool BoxProblem::is_solved(double tolerance) const {
  for (int i = 0; i < size_; ++i) {
    const double w = gradient(i);
    if (w < -tolerance && x[i] < high[i]) return false;
    if (w > tolerance && x[i] > low[i]) return false;
  }
  return true;
}

void BoxProblem::order_all_free() {
  order_count_ = 0;
  factorised_ = 0;
  for (int i = 0; i < size_; ++i) {
    if (bound_[i] == Bound::free && a(i, i) != 0.0) order_[order_count_++] = i;
  }
}

// What comes before the first of them in the factorisation is as it was.
void BoxProblem::drop_fixed() {
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
void BoxProblem::factorise() {
  for (int k = factorised_; k < order_count_; ++k) {
    const int i = order_[k];
    pivot_[i] = a(i, i);
    const double* row = &factor_[i * max_unknowns];
    for (int l = 0; l < factorised_; ++l) pivot_[i] -= row[l] * row[l];
  }
  for (int n = factorised_; n < order_count_; ++n) {
    int next = n;
    for (int k = n + 1; k < order_count_; ++k) {
      if (pivot_[order_[k]] > pivot_[order_[next]]) next = k;
    }
    std::swap(order_[n], order_[next]);
    const int i = order_[n];
    double* row = &factor_[i * max_unknowns];
    row[n] = std::sqrt(std::max(pivot_[i], least_pivot * a(i, i)));
    for (int k = n + 1; k < order_count_; ++k) {
      const int j = order_[k];
      double* other = &factor_[j * max_unknowns];
      double sum = a(j, i);
      for (int l = 0; l < n; ++l) sum -= other[l] * row[l];
      other[n] = sum / row[n];
      pivot_[j] -= other[n] * other[n];
    }
  }
  factorised_ = order_count_;
}

void BoxProblem::solve_free() {
  for (int i = 0; i < size_; ++i) target_[i] = x[i];
  factorise();
  const int n = order_count_;
  for (int k = 0; k < n; ++k) {
    double sum = -gradient(order_[k]);
    const double* row = &factor_[order_[k] * max_unknowns];
    for (int l = 0; l < k; ++l) sum -= row[l] * rhs_[l];
    rhs_[k] = sum / row[k];
  }
  for (int k = n - 1; k >= 0; --k) {
    double sum = rhs_[k];
    for (int l = k + 1; l < n; ++l) sum -= factor_[order_[l] * max_unknowns + k] * rhs_[l];
    rhs_[k] = sum / factor_[order_[k] * max_unknowns + k];
    target_[order_[k]] = x[order_[k]] + rhs_[k];
  }
}

bool BoxProblem::step_to_target() {
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

int BoxProblem::most_violating(double tolerance) const {
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

void BoxProblem::solve() {
  double scale = 0.0;
  for (int i = 0; i < size_; ++i) {
    x[i] = std::clamp(0.0, low[i], high[i]);
    // All are tried together first; those that would go the wrong way stop where they are. Most
    // contacts of a heap press, so this takes fewer rounds than to begin with none.
    bound_[i] = low[i] < high[i] ? Bound::free : Bound::fixed;
    banned_[i] = false;
    scale = std::max(scale, std::abs(b[i]));
  }
  const double tolerance = 1e-14 * scale;
  if (is_solved(tolerance)) return;
  // From far away each bound costs a round; a large problem is begun where it is nearly solved.
  if (size_ >= large) {
    const bool is_near = solve_softly(false);
    for (int i = 0; i < size_; ++i) {
      x[i] = std::clamp(is_near ? x[i] : 0.0, low[i], high[i]);
      if (!is_near) bound_[i] = low[i] < high[i] ? Bound::free : Bound::fixed;
    }
  }
  order_all_free();

  // Each round releases one bound; far fewer rounds than this are ever needed.
  for (int round = 0; round < 8 * max_unknowns; ++round) {
    do {
      solve_free();
    } while (!step_to_target());

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

// The larger the diagonal, the easier. Each of these problems is near the solution of the one
// before, and the last one says what that is to its own softness times how far the two are apart.
bool BoxProblem::solve_softly(bool again) {
  if (again && solve_near(softness.back())) return true;
  if (!again) {
    for (int i = 0; i < size_; ++i) {
      x[i] = 0.0;
      const bool starts_free = low[i] < 0.0 ? high[i] > 0.0 : b[i] < 0.0;
      bound_[i] = starts_free && a(i, i) != 0.0 ? Bound::free : Bound::fixed;
    }
  }
  std::size_t k = usual_softness;
  if (!solve_near(softness[k])) {
    k = 0;
    if (!solve_near(softness[k])) return false;
  }
  while (++k < softness.size()) {
    if (solve_near(softness[k])) continue;
    solve_near(softness[k - 1]);  // once more, from where it led: as good as it gets
    break;
  }
  return true;
}

// With a diagonal that pulls towards x as it is. Whole sets of wrong bounds are exchanged at once as
// long as that makes them fewer, else the last wrong one alone, which comes to an end for certain.
bool BoxProblem::solve_near(double soft) {
  double scale = 0.0;
  for (int i = 0; i < size_; ++i) {
    scale = std::max(scale, std::abs(b[i]));
    pull_[i] = soft * a(i, i);
    centre_[i] = x[i];
    if (bound_[i] == Bound::fixed) x[i] = x[i] - low[i] <= high[i] - x[i] ? low[i] : high[i];
  }
  const double tolerance = 1e-10 * scale;
  int fewest = size_ + 1;
  int patience = patient_rounds;
  for (int round = 0; round < most_soft_rounds; ++round) {
    solve_for_free();
    const int wrong = find_wrong(tolerance);
    if (wrong == 0) return true;
    if (wrong < fewest) {
      fewest = wrong;
      patience = patient_rounds;
    } else {
      --patience;
    }
    exchange_wrong(patience < 0);
  }
  for (int i = 0; i < size_; ++i) {
    x[i] = centre_[i];
    bound_[i] = x[i] <= low[i] || x[i] >= high[i] ? Bound::fixed : Bound::free;
  }
  return false;
}

// x of the free unknowns, the others held.
void BoxProblem::solve_for_free() {
  order_count_ = 0;
  std::array<int, max_unknowns> held;
  int held_count = 0;
  // The last ones first: wheels, whose rows are nearly empty.
  for (int i = size_ - 1; i >= 0; --i) {
    if (bound_[i] == Bound::free) {
      order_[order_count_++] = i;
    } else if (x[i] != 0.0) {
      held[held_count++] = i;
    }
  }
  // Row k of the upper triangle, with the right side behind it.
  const int n = order_count_;
  const auto row = [&](int k) { return &upper_factor_[k * (n + 1)]; };
  for (int k = 0; k < n; ++k) {
    const double* const a = &a_[order_[k] * max_unknowns];
    double* const u = row(k);
    for (int l = k; l < n; ++l) u[l] = a[order_[l]];
    u[k] += pull_[order_[k]];
    double right = pull_[order_[k]] * centre_[order_[k]] - b[order_[k]];
    for (int l = 0; l < held_count; ++l) right -= a[held[l]] * x[held[l]];
    u[n] = right;
  }
  for (int k = 0; k < n; ++k) {
    const double* const u = row(k);
    const double pivot = std::max(u[k], least_pivot * a(order_[k], order_[k]));
    pivot_[k] = 1.0 / pivot;
    for (int l = k + 1; l < n; ++l) {
      if (u[l] == 0.0) continue;
      subtract(u[l] * pivot_[k], u + l, n + 1 - l, row(l) + l);
    }
  }
  for (int k = n - 1; k >= 0; --k) {
    const double* const u = row(k);
    double sum = u[n];
    for (int l = k + 1; l < n; ++l) sum -= u[l] * rhs_[l];
    x[order_[k]] = rhs_[k] = sum * pivot_[k];
  }
}

// Free unknowns beyond their bounds, bounds that pull the wrong way.
int BoxProblem::find_wrong(double tolerance) {
  int count = 0;
  for (int i = 0; i < size_; ++i) {
    if (bound_[i] == Bound::free) {
      wrong_[i] = x[i] < low[i] || x[i] > high[i];
    } else {
      const bool is_given = low[i] == high[i] || a(i, i) == 0.0;
      const double w = is_given ? 0.0 : gradient(i) + pull_[i] * (x[i] - centre_[i]);
      wrong_[i] = x[i] <= low[i] ? w < -tolerance : w > tolerance;
    }
    count += wrong_[i];
  }
  return count;
}

void BoxProblem::exchange_wrong(bool only_last) {
  for (int i = size_ - 1; i >= 0; --i) {
    if (!wrong_[i]) continue;
    if (bound_[i] == Bound::free) {
      bound_[i] = Bound::fixed;
      x[i] = x[i] < low[i] ? low[i] : high[i];
    } else {
      bound_[i] = Bound::free;
    }
    if (only_last) return;
  }
}

}  // namespace mirocup::simulator
