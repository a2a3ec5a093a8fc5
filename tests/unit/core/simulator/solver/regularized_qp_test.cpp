// SPDX-License-Identifier: MIT
//
// Every solution is held against the conditions that define it. Catches bounds that are exchanged
// for ever, a pull to the wrong place, and a system that is kept though other unknowns are free
// now.
#include "core/simulator/solver/regularized_qp.hpp"

#include "core/base/random.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace mirocup::simulator::solver {
namespace {

// Rows between bodies at random, more than the bodies can be moved in; every third is boxed, the
// others push only. There is a solution: twists that no gap minds.
class RandomProblem {
 public:
  RandomProblem(RegularizedQp& problem, Random& random) : p_(problem) {
    const int bodies = 2 + static_cast<int>(random.below(max_bodies - 1));
    for (InverseMass& m : mass_) {
      m = {random.uniform(0.5, 2.0), random.uniform(0.5, 2.0), random.uniform(0.5, 2.0)};
    }
    mass_[0].left = 0.0;
    p_.reset(mass_);
    const auto row = [&random] {
      return JacobianRow{random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0),
                         random.uniform(-1.0, 1.0)};
    };
    const int size = 1 + static_cast<int>(random.below(5 * bodies));
    for (int i = 0; i < size; ++i) {
      ConstraintRow r{.a = static_cast<int>(random.below(bodies)),
                      .b = static_cast<int>(random.below(bodies)),
                      .on_a = row(),
                      .on_b = row()};
      if (r.a == r.b) r.b = no_body;
      rows_.push_back(r);
      p_.add(r);
      if (i % 3 == 2) {
        p_.low[i] = -0.1;
        p_.high[i] = 0.2;
      }
    }
    move_on(random);
  }

  // Another b, of other twists.
  void move_on(Random& random) {
    BodyVector v;
    for (JacobianRow& of : v) {
      for (double& value : of) value = random.uniform(-1.0, 1.0);
    }
    v[0][1] = 0.0;
    for (int i = 0; i < p_.size(); ++i) p_.b[i] = rate(rows_[i], v);
  }

  double worst_violation() const {
    BodyVector v{};
    for (int i = 0; i < p_.size(); ++i) {
      add(rows_[i].a, rows_[i].on_a, p_.x[i], v);
      if (rows_[i].b != no_body) add(rows_[i].b, rows_[i].on_b, p_.x[i], v);
    }
    double worst = 0.0;
    for (int i = 0; i < p_.size(); ++i) {
      const double w = p_.b[i] + rate(rows_[i], v);
      worst = std::max({worst, p_.low[i] - p_.x[i], p_.x[i] - p_.high[i]});
      if (p_.x[i] > p_.low[i]) worst = std::max(worst, w);
      if (p_.x[i] < p_.high[i]) worst = std::max(worst, -w);
    }
    return worst;
  }

 private:
  void add(int body, const JacobianRow& row, double impulse, BodyVector& v) const {
    v[body][0] += impulse * row[0] * mass_[body].forward;
    v[body][1] += impulse * row[1] * mass_[body].left;
    v[body][2] += impulse * row[2] * mass_[body].omega;
  }
  static double rate(const ConstraintRow& row, const BodyVector& v) {
    double sum = 0.0;
    for (int c = 0; c < 3; ++c) {
      sum += row.on_a[c] * v[row.a][c];
      if (row.b != no_body) sum += row.on_b[c] * v[row.b][c];
    }
    return sum;
  }

  RegularizedQp& p_;
  std::array<InverseMass, max_bodies> mass_;
  std::vector<ConstraintRow> rows_;
};

// Soft solutions are as good as their softness, also where contacts are redundant, and better when
// asked for again.
TEST(RegularizedQp, Solves) {
  Random random(2);
  RegularizedQp p;
  for (int i = 0; i < 300; ++i) {
    const RandomProblem problem(p, random);
    ASSERT_TRUE(p.solve()) << "case " << i;
    ASSERT_LE(problem.worst_violation(), 1e-3) << "case " << i << ", size " << p.size();
    for (int again = 0; again < 10; ++again) p.solve();
    ASSERT_LE(problem.worst_violation(), 1e-6) << "case " << i << ", size " << p.size();
  }
}

// What is solved for another b begins where the last one ended.
TEST(RegularizedQp, SolvesForAnotherB) {
  Random random(4);
  RegularizedQp p;
  for (int i = 0; i < 300; ++i) {
    RandomProblem problem(p, random);
    p.solve();
    for (int change = 0; change < 5; ++change) {
      problem.move_on(random);
      for (int again = 0; again < 5; ++again) ASSERT_TRUE(p.solve());
      ASSERT_LE(problem.worst_violation(), 1e-5) << "case " << i << ", size " << p.size();
    }
  }
}

// What is remembered of the last look changes no bit. Catches rates that are taken for those of
// another x, or of other rows.
TEST(RegularizedQp, RemembersWhatWouldBeFoundAnew) {
  RegularizedQp p;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    Random random(seed);
    RandomProblem problem(p, random);
    p.solve();
    const Unknowns before = p.x;
    problem.move_on(random);
    p.solve();

    Random same(seed);
    RegularizedQp fresh;
    RandomProblem again(fresh, same);
    fresh.x = before;
    again.move_on(same);
    fresh.solve();
    for (int i = 0; i < p.size(); ++i) ASSERT_EQ(p.x[i], fresh.x[i]) << "seed " << seed;
  }
}

// A row of a body that cannot be moved, and one whose bounds leave nothing: catches a division by
// what such a row gives.
TEST(RegularizedQp, LeavesGivenUnknowns) {
  RegularizedQp p;
  const std::array<InverseMass, 1> mass{InverseMass{1.0, 0.0, 1.0}};
  p.reset(mass);
  p.add({.a = 0, .b = no_body, .on_a = {0.0, 1.0, 0.0}, .on_b = {}});
  p.add({.a = 0, .b = no_body, .on_a = {1.0, 0.0, 0.0}, .on_b = {}});
  p.add({.a = 0, .b = no_body, .on_a = {1.0, 0.0, 0.5}, .on_b = {}});
  p.b = {-1.0, -1.0, 0.0};
  p.low[1] = p.high[1] = 0.5;
  EXPECT_TRUE(p.solve());
  EXPECT_EQ(p.x[0], 0.0);
  EXPECT_EQ(p.x[1], 0.5);
  EXPECT_EQ(p.x[2], 0.0);
}

}  // namespace
}  // namespace mirocup::simulator::solver
