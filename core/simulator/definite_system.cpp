// SPDX-License-Identifier: MIT
#include "core/simulator/definite_system.hpp"

namespace mirocup::simulator {

namespace {

void subtract(double factor, const double* __restrict row, int count, double* __restrict from) {
  for (int i = 0; i < count; ++i) from[i] -= factor * row[i];
}

void subtract_both(double factor, const double* __restrict row, double other_factor,
                   const double* __restrict other, int count, double* __restrict from) {
  for (int i = 0; i < count; ++i) from[i] = (from[i] - factor * row[i]) - other_factor * other[i];
}

// In four sums, which a processor can work on at once.
double dot(const double* p, const double* q, int count) {
  double s0 = 0.0, s1 = 0.0, s2 = 0.0, s3 = 0.0;
  int i = 0;
  for (; i + 3 < count; i += 4) {
    s0 += p[i] * q[i];
    s1 += p[i + 1] * q[i + 1];
    s2 += p[i + 2] * q[i + 2];
    s3 += p[i + 3] * q[i + 3];
  }
  for (; i < count; ++i) s0 += p[i] * q[i];
  return (s0 + s1) + (s2 + s3);
}

}  // namespace

DefiniteSystem::DefiniteSystem(int most_unknowns)
    : upper_(static_cast<std::size_t>(most_unknowns * most_unknowns)),
      inverse_pivot_(static_cast<std::size_t>(most_unknowns)) {}

// Row k from all rows below it. Many entries are zero: bodies that do not touch.
void DefiniteSystem::eliminate_one(int k) {
  const double* const u = row(k);
  inverse_pivot_[k] = 1.0 / u[k];
  for (int l = k + 1; l < size_; ++l) {
    if (u[l] != 0.0) subtract(u[l] * inverse_pivot_[k], u + l, size_ - l, row(l) + l);
  }
}

// Rows k and k + 1 from all rows below them, which are read and written once for both.
void DefiniteSystem::eliminate_two(int k) {
  const double* const u = row(k);
  const double* const v = row(k + 1);
  inverse_pivot_[k] = 1.0 / u[k];
  if (u[k + 1] != 0.0) {
    subtract(u[k + 1] * inverse_pivot_[k], u + k + 1, size_ - k - 1, row(k + 1) + k + 1);
  }
  inverse_pivot_[k + 1] = 1.0 / v[k + 1];
  for (int l = k + 2; l < size_; ++l) {
    double* const to = row(l) + l;
    const double by_u = u[l] * inverse_pivot_[k];
    const double by_v = v[l] * inverse_pivot_[k + 1];
    if (by_u != 0.0 && by_v != 0.0) {
      subtract_both(by_u, u + l, by_v, v + l, size_ - l, to);
    } else if (by_u != 0.0) {
      subtract(by_u, u + l, size_ - l, to);
    } else if (by_v != 0.0) {
      subtract(by_v, v + l, size_ - l, to);
    }
  }
}

void DefiniteSystem::factorise() {
  int k = 0;
  for (; k + 1 < size_; k += 2) eliminate_two(k);
  if (k < size_) eliminate_one(k);
}

void DefiniteSystem::solve(double* rhs) const {
  for (int k = 0; k < size_; ++k) {
    const double by = rhs[k] * inverse_pivot_[k];
    if (by != 0.0) subtract(by, row(k) + k + 1, size_ - k - 1, rhs + k + 1);
  }
  for (int k = size_ - 1; k >= 0; --k) {
    const double others = dot(row(k) + k + 1, rhs + k + 1, size_ - k - 1);
    rhs[k] = (rhs[k] - others) * inverse_pivot_[k];
  }
}

}  // namespace mirocup::simulator
