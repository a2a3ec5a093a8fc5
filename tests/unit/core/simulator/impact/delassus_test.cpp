// SPDX-License-Identifier: MIT
#include "core/simulator/impact/delassus.hpp"

#include "core/base/random.hpp"

#include <gtest/gtest.h>

#include <array>
#include <memory>
#include <vector>

namespace mirocup::simulator::impact {
namespace {

// Column j must be what a unit impulse along row j does to all rates. Catches bodies whose rows are
// coupled with the wrong sign, and entries that are missing or counted twice.
TEST(Delassus, ColumnsAreTheResponsesToUnitImpulses) {
  constexpr int bodies = 5;
  constexpr int rows = 12;
  Random random(9);
  const auto number = [&random] { return random.uniform(-1.0, 1.0); };
  std::array<solver::InverseMass, bodies> mass;
  for (solver::InverseMass& m : mass) m = {random.uniform(), random.uniform(), random.uniform()};
  std::vector<solver::ConstraintRow> row(rows);
  for (solver::ConstraintRow& r : row) {
    r.a = static_cast<int>(random.below(bodies));
    const int other = static_cast<int>(random.below(bodies));
    r.b = other == r.a ? no_body : other;
    r.on_a = {number(), number(), number()};
    if (r.b != no_body) r.on_b = {number(), number(), number()};
  }
  const auto problem = std::make_unique<solver::BoxQp>();
  problem->reset(rows);
  assemble_delassus(
      rows, [&](int i) -> const solver::ConstraintRow& { return row[i]; }, mass, *problem);
  for (int j = 0; j < rows; ++j) {
    std::array<BodyState, bodies> at_rest{};
    collision::apply_impulse(row[j], 1.0, mass, at_rest);
    for (int i = 0; i < rows; ++i) {
      EXPECT_NEAR(problem->a(i, j), collision::row_rate(row[i], at_rest), 1e-14) << i << " " << j;
    }
    EXPECT_NEAR(problem->a(j, j), collision::inverse_effective_mass(row[j], mass), 1e-14);
  }
}

// A body of infinite mass couples nothing. Catches a mass that is inverted once more.
TEST(Delassus, ImmovableBodiesCoupleNoRows) {
  const std::array<solver::InverseMass, 3> mass{solver::InverseMass{1.0, 1.0, 1.0},
                                                solver::InverseMass{},
                                                solver::InverseMass{1.0, 1.0, 1.0}};
  const std::array<solver::ConstraintRow, 2> row{
      solver::ConstraintRow{.a = 0, .b = 1, .on_a = {1.0, 0.0, 0.0}, .on_b = {-1.0, 0.0, 0.0}},
      solver::ConstraintRow{.a = 2, .b = 1, .on_a = {1.0, 0.0, 0.0}, .on_b = {-1.0, 0.0, 0.0}}};
  const auto problem = std::make_unique<solver::BoxQp>();
  problem->reset(2);
  assemble_delassus(
      2, [&](int i) -> const solver::ConstraintRow& { return row[i]; }, mass, *problem);
  EXPECT_EQ(problem->a(0, 1), 0.0);
  EXPECT_EQ(problem->a(0, 0), 1.0);
}

}  // namespace
}  // namespace mirocup::simulator::impact
