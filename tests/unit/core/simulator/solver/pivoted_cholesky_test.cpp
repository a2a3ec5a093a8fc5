// SPDX-License-Identifier: MIT
#include "core/simulator/solver/pivoted_cholesky.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

namespace mirocup::simulator::solver {
namespace {

// The Gram matrix of `rows`.
template <std::size_t n>
void set_gram(const std::array<std::array<double, 3>, n>& rows, PivotedCholesky& e) {
  e.reset(n);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      double sum = 0.0;
      for (int k = 0; k < 3; ++k) sum += rows[i][k] * rows[j][k];
      e.a(static_cast<int>(i), static_cast<int>(j)) = sum;
    }
  }
}

TEST(PivotedCholesky, SolvesWhatIsIndependent) {
  PivotedCholesky e;
  set_gram<3>({{{2.0, 0.0, 0.0}, {1.0, 3.0, 0.0}, {0.5, -1.0, 1.0}}}, e);
  e.factorise();
  const std::array<double, 3> x{1.0, -2.0, 3.0};
  std::array<double, max_unknowns> rhs{};
  for (int i = 0; i < 3; ++i) {
    EXPECT_FALSE(e.is_redundant(i));
    for (int j = 0; j < 3; ++j) rhs[i] += e.a(std::max(i, j), std::min(i, j)) * x[j];
  }
  e.solve(rhs);
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(rhs[i], x[i], 1e-13);
}

// Two contacts that push the same: the first in order takes it, the other is named and left at
// zero. Dividing by what rounding leaves of the second one's pivot would give forces of any size.
TEST(PivotedCholesky, NamesAnEquationThatFollowsFromOthers) {
  PivotedCholesky e;
  const double third = 1.0 / 3.0;
  set_gram<4>(
      {{{1.0, third, 0.0}, {third, 1.0, 0.0}, {1.0 + third, 1.0 + third, 0.0}, {0.0, 0.0, 1.0}}},
      e);
  e.factorise();
  int dependent = 0;
  for (int i = 0; i < 4; ++i) dependent += e.is_redundant(i);
  EXPECT_EQ(dependent, 1);
  EXPECT_FALSE(e.is_redundant(3));
  std::array<double, max_unknowns> rhs{};
  for (int i = 0; i < 4; ++i) rhs[i] = e.a(i, 0);  // for any i: a(0, i) of x = (1, 0, 0, 0)
  e.solve(rhs);
  for (int i = 0; i < 4; ++i) {
    if (e.is_redundant(i)) {
      EXPECT_EQ(rhs[i], 0.0);
    }
    double sum = 0.0;
    for (int j = 0; j < 4; ++j) sum += e.a(std::max(i, j), std::min(i, j)) * rhs[j];
    EXPECT_NEAR(sum, e.a(i, 0), 1e-12);
  }
}

}  // namespace
}  // namespace mirocup::simulator::solver
