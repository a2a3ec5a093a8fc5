// SPDX-License-Identifier: MIT
#include "core/simulator/solver/pivoted_cholesky.hpp"

#include "core/base/assert.hpp"
#include "core/simulator/model/solver_settings.hpp"

#include <algorithm>
#include <cmath>

namespace mirocup::simulator::solver {

PivotedCholesky::PivotedCholesky()
    : a_(std::make_unique_for_overwrite<double[]>(max_unknowns * max_unknowns)),
      factor_(std::make_unique_for_overwrite<double[]>(max_unknowns * max_unknowns)),
      packed_(std::make_unique_for_overwrite<double[]>(max_unknowns * (max_unknowns + 1) / 2)) {}

void PivotedCholesky::reset(int n) {
  MIROCUP_ASSERT(0 <= n && n <= max_unknowns);
  size_ = n;
  spoil(order_, pivot_, redundant_);
  spoil_n(factor_.get(), n * n);
  std::fill_n(a_.get(), n * n, 0.0);
}

// The pivot of an equation that nearly depends on others is mostly rounding, and dividing by it
// would spoil all equations after it. So these come last, the largest pivot first.
void PivotedCholesky::factorise() {
  const int n = size_;
  for (int i = 0; i < n; ++i) {
    pivot_[i] = a(i, i);
    order_[i] = i;
  }
  int taken = 0;
  for (int place = 0; place < n; ++place) {
    const int i = order_[place];
    if (pivot_[i] > settings::pivoted_cholesky.independent_pivot * a(i, i))
      eliminate(place, taken++);
  }
  while (taken < n) {
    int largest = taken;
    for (int place = taken + 1; place < n; ++place) {
      if (pivot_[order_[place]] > pivot_[order_[largest]]) largest = place;
    }
    eliminate(largest, taken++);
  }
  pack();
}

// Copies the rows one after the other, as solve() reads them, because solve() is called for every
// term of a motion.
void PivotedCholesky::pack() {
  double* to = packed_.get();
  for (int k = 0; k < size_; ++k) {
    const double* row = &factor_[order_[k] * size_];
    to = std::copy_n(row, k + 1, to);
  }
}

// Eliminates the equation at order_[place] as number `taken`. Those passed over keep their order.
void PivotedCholesky::eliminate(int place, int taken) {
  std::rotate(order_.begin() + taken, order_.begin() + place, order_.begin() + place + 1);
  const int i = order_[taken];
  double* row = &factor_[i * size_];
  redundant_[i] = pivot_[i] <= settings::pivoted_cholesky.redundant_pivot * a(i, i);
  row[taken] = redundant_[i] ? 1.0 : std::sqrt(pivot_[i]);
  for (int k = taken + 1; k < size_; ++k) {
    const int j = order_[k];
    double* other = &factor_[j * size_];
    other[taken] = 0.0;
    if (redundant_[i]) continue;
    double sum = a(std::max(i, j), std::min(i, j));
    for (int l = 0; l < taken; ++l) sum -= other[l] * row[l];
    other[taken] = sum / row[taken];
    pivot_[j] -= other[taken] * other[taken];
  }
}

void PivotedCholesky::solve(std::array<double, max_unknowns>& rhs) const {
  std::array<double, max_unknowns> y;
  const double* row = packed_.get();
  for (int k = 0; k < size_; ++k) {
    const int i = order_[k];
    double sum = rhs[i];
    for (int l = 0; l < k; ++l) sum -= row[l] * y[l];
    y[k] = redundant_[i] ? 0.0 : sum / row[k];
    row += k + 1;
  }
  for (int k = size_ - 1; k >= 0; --k) {
    row -= k + 1;
    const int i = order_[k];
    if (!redundant_[i]) y[k] /= row[k];
    for (int l = 0; l < k; ++l) y[l] -= row[l] * y[k];
    rhs[i] = y[k];
  }
}

}  // namespace mirocup::simulator::solver
