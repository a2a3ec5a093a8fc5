// SPDX-License-Identifier: MIT
//
// Catches a root finder that skips a root, takes a later one first, or stops short.
#include "core/simulator/trajectory/taylor_series.hpp"

#include "core/base/random.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace mirocup::simulator::trajectory {
namespace {

// (t - root) (t - root) ... as a series.
Series with_roots(std::initializer_list<double> roots, double factor) {
  Series p;
  p[0] = factor;
  for (const double root : roots) {
    Series next;
    for (int k = 0; k < max_terms; ++k) next[k] = (k > 0 ? p[k - 1] : 0.0) - root * p[k];
    p = next;
  }
  return p;
}

TEST(Series, ShiftKeepsThePolynomial) {
  Random random(1);
  Series p;
  for (double& c : p.c) c = random.uniform(-1.0, 1.0);
  const Series q = shifted(p, 0.3);
  for (const double t : {0.0, 0.1, 0.4}) EXPECT_NEAR(q.at(t), p.at(t + 0.3), 1e-14);
}

TEST(Series, ProductIsTruncatedNotWrapped) {
  const Series p = with_roots({0.2, 0.5}, 1.0);
  const Series q = with_roots({0.9}, 2.0);
  EXPECT_NEAR((p * q).at(0.7), p.at(0.7) * q.at(0.7), 1e-15);
}

// With the same bits: terms or factors in another order would make other states.
TEST(Series, SumsOfProductsAreWhatTheyAreByThemselves) {
  Random random(3);
  for (const int terms : term_counts) {
    std::array<Series, 4> p;
    for (Series& series : p) {
      series.terms = &series == &p[1] ? min_terms : terms;
      for (int k = 0; k < series.terms; ++k) series[k] = random.uniform(-1.0, 1.0);
    }
    EXPECT_EQ(sum_of_products(p[0], p[1], p[2], p[3]).c, (p[0] * p[1] + p[2] * p[3]).c);
    EXPECT_EQ(difference_of_products(p[0], p[1], p[2], p[3]).c, (p[0] * p[1] - p[2] * p[3]).c);
    EXPECT_EQ(sum_of_products(p[0], p[1], p[2], p[3]).terms, terms);
  }
}

TEST(FirstFall, FindsTheFirstOfSeveralRoots) {
  const Series p = with_roots({0.011, 0.017, 0.029}, -1e5);
  EXPECT_GT(p[0], 0.0);
  EXPECT_NEAR(first_crossing(p, 0.0, 0.0, 0.033), 0.011, 1e-12);
  EXPECT_NEAR(first_crossing(p, 0.0, 0.018, 0.033), 0.029, 1e-12);
  EXPECT_EQ(first_crossing(p, 0.0, 0.018, 0.028), never);
}

TEST(FirstFall, SeesAGrazeAndPassesANearMiss) {
  // Touches zero at 0.01 and rises again; then the same lifted by a nanometre.
  const Series graze = with_roots({0.01, 0.01}, 1.0);
  EXPECT_NEAR(first_crossing(graze, 0.0, 0.0, 0.033), 0.01, 2e-7);
  Series miss = graze;
  miss[0] += 1e-9;
  EXPECT_EQ(first_crossing(miss, 0.0, 0.0, 0.033), never);
}

TEST(FirstFall, AgreesWithAFineScanOnRandomPolynomials) {
  Random random(2);
  int hits = 0;
  for (int i = 0; i < 2000; ++i) {
    Series p;
    double scale = 1.0;
    for (double& c : p.c) {
      c = scale * random.uniform(-1.0, 1.0);
      scale *= 2.0;
    }
    p[0] = random.uniform(0.01, 0.5);
    const double found = first_crossing(p, 0.0, 0.0, 1.0);
    const int cells = 4000;
    double scanned = never;
    for (int k = 1; k <= cells && scanned == never; ++k) {
      const double t = k / static_cast<double>(cells);
      if (p.at(t) < 0.0) scanned = t;
    }
    if (scanned == never) continue;
    ++hits;
    ASSERT_LE(found, scanned) << "skipped a root, case " << i;
    EXPECT_LE(std::abs(p.at(found)), 1e-12);
  }
  EXPECT_GT(hits, 500);
}

}  // namespace
}  // namespace mirocup::simulator::trajectory
