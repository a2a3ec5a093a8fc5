// SPDX-License-Identifier: MIT
//
// Catches a difference with the wrong sign, and a row whose only body is put into the wrong half.
#include "core/simulator/solver/constraint_row.hpp"

#include <gtest/gtest.h>

namespace mirocup::simulator::solver {
namespace {

constexpr JacobianRow row_a{1.0, -2.0, 3.0};
constexpr JacobianRow row_b{0.5, 0.25, -4.0};
const Twist twist_a{0.3, 0.1, -2.0};
const Twist twist_b{-0.7, 0.2, 1.5};

TEST(ConstraintRow, OfTwoBodiesIsTheDifferenceOfTheirRates) {
  const ConstraintRow row = difference_row(4, 2, row_a, row_b);
  EXPECT_EQ(row.a, 4);
  EXPECT_EQ(row.b, 2);
  EXPECT_DOUBLE_EQ(along(row.on_a, twist_a) + along(row.on_b, twist_b),
                   along(row_a, twist_a) - along(row_b, twist_b));
}

TEST(ConstraintRow, OfABodyAndAnObstacleHasTheBodyFirst) {
  const ConstraintRow first = difference_row(4, no_body, row_a, row_b);
  EXPECT_EQ(first.a, 4);
  EXPECT_EQ(first.b, no_body);
  EXPECT_DOUBLE_EQ(along(first.on_a, twist_a), along(row_a, twist_a));
  const ConstraintRow second = difference_row(no_body, 2, row_a, row_b);
  EXPECT_EQ(second.a, 2);
  EXPECT_EQ(second.b, no_body);
  EXPECT_DOUBLE_EQ(along(second.on_a, twist_b), -along(row_b, twist_b));
}

}  // namespace
}  // namespace mirocup::simulator::solver
