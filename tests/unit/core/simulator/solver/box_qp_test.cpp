// SPDX-License-Identifier: MIT
//
// Every solution is held against the conditions that define it. Catches a bound that is not
// released, a free unknown that is not solved, a singular matrix that stalls.
#include "core/simulator/solver/box_qp.hpp"

#include "core/base/math.hpp"
#include "core/base/random.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace mirocup::simulator::solver {
namespace {

double worst_violation(const BoxQp& p) {
  double worst = 0.0;
  for (int i = 0; i < p.size(); ++i) {
    double w = p.b[i];
    for (int j = 0; j < p.size(); ++j) w += p.a(i, j) * p.x[j];
    worst = std::max({worst, p.low[i] - p.x[i], p.x[i] - p.high[i]});
    if (p.x[i] > p.low[i]) worst = std::max(worst, w);
    if (p.x[i] < p.high[i]) worst = std::max(worst, -w);
  }
  return worst;
}

// A = G G' with G of the given rank; every third unknown is boxed.
void make_random(BoxQp& p, int size, int rank, Random& random) {
  p.reset(size);
  std::vector<double> g(size * rank);
  for (double& x : g) x = random.uniform(-1.0, 1.0);
  std::vector<double> v(rank);
  for (double& x : v) x = random.uniform(-1.0, 1.0);
  for (int i = 0; i < size; ++i) {
    // b in the range of G: the problem has a solution even where A is singular.
    for (int k = 0; k < rank; ++k) p.b[i] += g[i * rank + k] * v[k];
    for (int j = 0; j < size; ++j) {
      for (int k = 0; k < rank; ++k) p.a(i, j) += g[i * rank + k] * g[j * rank + k];
    }
    if (i % 3 == 2) {
      p.low[i] = -0.1;
      p.high[i] = 0.2;
    }
  }
}

// Rows that contradict each other have no solution. Catches bounds that are released in circles,
// with ever larger unknowns: it ends, within the bounds and not above where it began.
TEST(BoxQp, EndsWhereRowsContradict) {
  Random random(5);
  BoxQp p;
  for (int i = 0; i < 100; ++i) {
    const int size = 40 + static_cast<int>(random.below(60));
    make_random(p, size, size / 3, random);
    for (int k = 0; k < size; ++k) {
      p.b[k] += 1e-9 * random.uniform(-1.0, 1.0);
      if (k % 3 == 0) p.low[k] = -infinity;
    }
    p.solve();
    double value = 0.0;
    for (int k = 0; k < size; ++k) {
      ASSERT_GE(p.x[k], p.low[k]);
      ASSERT_LE(p.x[k], p.high[k]);
      value += 0.5 * p.x[k] * (p.gradient(k) + p.b[k]);
    }
    EXPECT_LE(value, 0.0) << "case " << i << ", size " << size;
  }
}

// Solves problems of `least` to `most` unknowns whose matrices have the rank `rank_of(size)`.
template <class Rank>
void expect_solved(Random random, int runs, int least, int most, Rank rank_of, double limit) {
  BoxQp p;
  for (int i = 0; i < runs; ++i) {
    const int size = least + static_cast<int>(random.below(most + 1 - least));
    make_random(p, size, rank_of(size), random);
    p.solve();
    ASSERT_LE(worst_violation(p), limit) << "case " << i << ", size " << size;
  }
}

TEST(BoxQp, SolvesRandomProblems) {
  expect_solved(
      Random(1), 3000, 1, 24, [](int size) { return size + 2; }, 1e-9);
}

TEST(BoxQp, SolvesRedundantContactsAlsoIfThereAreMany) {
  for (const int share : {2, 3, 8}) {
    const auto rank = [share](int size) { return 1 + size / share; };
    expect_solved(Random(2), 1000, 2, 25, rank, 1e-7);
    expect_solved(Random(3), 50, 32, 91, rank, 1e-6);
  }
}

// Contacts close beside each other in a heap: catches a factorisation that divides by what rounding
// leaves of a small pivot until it overflows.
TEST(BoxQp, SolvesNearlyRedundantContacts) {
  Random random(3);
  BoxQp p;
  for (int i = 0; i < 300; ++i) {
    constexpr int rank = 12;
    constexpr int size = 48;
    std::vector<double> g(size * rank);
    for (int row = 0; row < size; ++row) {
      for (int k = 0; k < rank; ++k) {
        // The last quarter of the unknowns hardly counts, so pivots get small but not zero.
        const double scale = k < 3 * rank / 4 ? 1.0 : 1e-4;
        g[row * rank + k] = scale * random.uniform(-1.0, 1.0);
      }
    }
    p.reset(size);
    for (int row = 0; row < size; ++row) {
      for (int j = 0; j < size; ++j) {
        for (int k = 0; k < rank; ++k) p.a(row, j) += g[row * rank + k] * g[j * rank + k];
      }
    }
    // One unknown is boxed, so that there is something to find on the way.
    p.high[0] = 0.1;
    for (int row = 0; row < size; ++row) p.b[row] = g[row * rank] + 0.5 * g[row * rank + 1];
    p.solve();
    for (int row = 0; row < size; ++row) ASSERT_TRUE(std::isfinite(p.x[row])) << "case " << i;
    ASSERT_LE(worst_violation(p), 1e-7) << "case " << i;
  }
}

TEST(BoxQp, OneContactIsADivision) {
  BoxQp p;
  p.reset(1);
  p.a(0, 0) = 4.0;
  p.b[0] = -2.0;
  p.solve();
  EXPECT_EQ(p.x[0], 0.5);
  p.b[0] = 2.0;
  p.solve();
  EXPECT_EQ(p.x[0], 0.0);
}

TEST(BoxQp, ContradictionGoesToTheBound) {
  // Two equal rows that ask for different things: one of the two contacts lets go.
  BoxQp p;
  p.reset(2);
  for (int i = 0; i < 2; ++i) {
    for (int j = 0; j < 2; ++j) p.a(i, j) = 1.0;
  }
  p.b[0] = -1.0;
  p.b[1] = -2.0;
  p.solve();
  EXPECT_NEAR(p.x[0], 0.0, 1e-9);
  EXPECT_NEAR(p.x[1], 2.0, 1e-9);
}

}  // namespace
}  // namespace mirocup::simulator::solver
