// SPDX-License-Identifier: MIT
//
// Solutions are put back into their equations. Catches a block that is transposed the wrong way
// round, two that the elimination of a third couples and no row does, and one that is left over
// from before.
#include "core/simulator/solver/block_cholesky.hpp"

#include "core/base/random.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace mirocup::simulator::solver {
namespace {

JacobianRow random_row(Random& random) {
  return {random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0)};
}

double rate(const ConstraintRow& row, const BodyVector& v) {
  double sum = 0.0;
  for (int c = 0; c < 3; ++c) {
    sum += row.on_a[c] * v[row.a][c];
    if (row.b != no_body) sum += row.on_b[c] * v[row.b][c];
  }
  return sum;
}

TEST(BlockCholesky, SolvesForSeveralRightSides) {
  Random random(1);
  BlockCholesky system;
  std::array<InverseMass, max_bodies> mass;
  for (int run = 0; run < 300; ++run) {
    BodySet bodies;
    const int n = 1 + static_cast<int>(random.below(max_bodies));
    for (int i = 0; i < n; ++i) bodies.set(random.below(max_bodies));
    std::vector<int> some;
    for (int i = 0; i < max_bodies; ++i) {
      if (bodies[i]) some.push_back(i);
      mass[i] = {random.uniform(0.5, 2.0), random.uniform(0.5, 2.0), random.uniform(0.5, 2.0)};
    }
    system.reset(bodies, mass);
    std::vector<ConstraintRow> rows;
    for (int k = 0; k < 2 * n; ++k) {
      ConstraintRow row{.a = some[random.below(some.size())],
                        .b = some[random.below(some.size())],
                        .on_a = random_row(random),
                        .on_b = random_row(random)};
      if (row.a == row.b) row.b = no_body;
      rows.push_back(row);
      system.add(row, 3.0);
    }
    system.factorise();
    for (int side = 0; side < 3; ++side) {
      BodyVector x{};
      BodyVector b{};
      for (const int i : some) x[i] = b[i] = random_row(random);
      system.solve(x);
      for (const int i : some) {
        b[i][0] -= x[i][0] / mass[i].forward;
        b[i][1] -= x[i][1] / mass[i].left;
        b[i][2] -= x[i][2] / mass[i].omega;
      }
      for (const ConstraintRow& row : rows) {
        const double by = 3.0 * rate(row, x);
        for (int c = 0; c < 3; ++c) {
          b[row.a][c] -= by * row.on_a[c];
          if (row.b != no_body) b[row.b][c] -= by * row.on_b[c];
        }
      }
      for (const int i : some) {
        for (int c = 0; c < 3; ++c) ASSERT_NEAR(b[i][c], 0.0, 1e-12) << "run " << run;
      }
    }
  }
}

// A robot on wheels of infinite grip does not go sideways, a ball does not turn; both may be pushed
// there. Catches an infinite mass that becomes a NaN.
TEST(BlockCholesky, HoldsWhatHasNoInverseMass) {
  BlockCholesky system;
  std::array<InverseMass, max_bodies> mass;
  mass[0] = {1.0, 0.0, 2.0};
  mass[1] = {1.0, 1.0, 0.0};
  system.reset(BodySet(3), mass);
  system.add({.a = 0, .b = 1, .on_a = {1.0, 1.0, 0.5}, .on_b = {-1.0, -1.0, 0.3}}, 10.0);
  system.factorise();
  BodyVector x{};
  x[0] = {1.0, 5.0, 0.0};
  x[1] = {0.0, 1.0, 7.0};
  system.solve(x);
  EXPECT_EQ(x[0][1], 0.0);
  EXPECT_EQ(x[1][2], 0.0);
  const double by = 10.0 * (x[0][0] + 0.5 * x[0][2] - x[1][0] - x[1][1]);
  EXPECT_NEAR(x[0][0] + by, 1.0, 1e-14);
  EXPECT_NEAR(x[0][2] / 2.0 + 0.5 * by, 0.0, 1e-14);
  EXPECT_NEAR(x[1][0] - by, 0.0, 1e-14);
  EXPECT_NEAR(x[1][1] - by, 1.0, 1e-14);
}

}  // namespace
}  // namespace mirocup::simulator::solver
