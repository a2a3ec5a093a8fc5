// SPDX-License-Identifier: MIT
#include "core/simulator/elimination.hpp"

#include <algorithm>
#include <cmath>

namespace mirocup::simulator {

namespace {

// As in complementarity.cpp.
constexpr double dependent_pivot = 1e-11;

// Equations with a pivot above this share of their diagonal are clear of the others.
constexpr double independent_pivot = 1e-3;

}  // namespace

Elimination::Elimination()
    : a_(max_unknowns * max_unknowns), factor_(max_unknowns * max_unknowns) {}

// What nearly depends on others comes behind all that are clear, the largest pivot first: dividing
// by what rounding leaves of a small one would spoil the others.
void Elimination::factorise(int n) {
  size_ = n;
  for (int i = 0; i < n; ++i) {
    pivot_[i] = a(i, i);
    order_[i] = i;
  }
  int taken = 0;
  for (int place = 0; place < n; ++place) {
    const int i = order_[place];
    if (pivot_[i] > independent_pivot * a(i, i)) take(place, taken++);
  }
  while (taken < n) {
    int largest = taken;
    for (int place = taken + 1; place < n; ++place) {
      if (pivot_[order_[place]] > pivot_[order_[largest]]) largest = place;
    }
    take(largest, taken++);
  }
}

void Elimination::take(int place, int taken) {
  // Those passed over keep their order.
  std::rotate(order_.begin() + taken, order_.begin() + place, order_.begin() + place + 1);
  const int i = order_[taken];
  double* row = &factor_[i * max_unknowns];
  depends_[i] = pivot_[i] <= dependent_pivot * a(i, i);
  row[taken] = depends_[i] ? 1.0 : std::sqrt(pivot_[i]);
  for (int k = taken + 1; k < size_; ++k) {
    const int j = order_[k];
    double* other = &factor_[j * max_unknowns];
    other[taken] = 0.0;
    if (depends_[i]) continue;
    double sum = a(std::max(i, j), std::min(i, j));
    for (int l = 0; l < taken; ++l) sum -= other[l] * row[l];
    other[taken] = sum / row[taken];
    pivot_[j] -= other[taken] * other[taken];
  }
}

void Elimination::solve(std::array<double, max_unknowns>& rhs) const {
  for (int k = 0; k < size_; ++k) {
    const int i = order_[k];
    const double* row = &factor_[i * max_unknowns];
    double sum = rhs[i];
    for (int l = 0; l < k; ++l) sum -= row[l] * rhs[order_[l]];
    rhs[i] = depends_[i] ? 0.0 : sum / row[k];
  }
  for (int k = size_ - 1; k >= 0; --k) {
    const int i = order_[k];
    if (depends_[i]) continue;
    double sum = rhs[i];
    for (int l = k + 1; l < size_; ++l) {
      sum -= factor_[order_[l] * max_unknowns + k] * rhs[order_[l]];
    }
    rhs[i] = sum / factor_[i * max_unknowns + k];
  }
}

}  // namespace mirocup::simulator
