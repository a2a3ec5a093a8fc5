// SPDX-License-Identifier: MIT
//
// Catches a test by the centre alone, an arc that is left out or counted twice, a goal's inside
// that is forgotten, and an end that counts otherwise.
#include "core/field/coverage.hpp"

#include "core/base/random.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace mirocup::field {
namespace {

constexpr double side = 0.075;

double part(const Field& field, const Area& area, const Pose& pose) {
  return covered_part(field, area, End::right, pose, side);
}

Pose at(double x, double y, double angle = 0.0) {
  return {{x, y}, Heading::from_angle(angle)};
}

TEST(Coverage, IsWholeInsideAndNothingOutside) {
  const Field f = make_field(RobotLeague::small);
  EXPECT_EQ(part(f, f.goal_area, at(0.675, 0.2, 0.3)), 1.0);
  EXPECT_EQ(part(f, f.goal_area, at(0.4, 0.0)), 0.0);
  EXPECT_EQ(part(f, f.goal_area, at(-0.7, 0.0)), 0.0) << "the other end's";
  EXPECT_NEAR(part(f, f.goal_area, at(0.75, 0.0, 0.4)), 1.0, 1e-12) << "half in the goal";
  EXPECT_NEAR(part(f, f.goal_area, at(0.80, 0.0)), 1.0, 1e-12);
}

TEST(Coverage, IsHalfOnAStraightLineAtAnyHeading) {
  const Field f = make_field(RobotLeague::middle);
  for (const double angle : {0.0, 0.1, 0.5, 0.785, 1.3}) {
    EXPECT_NEAR(part(f, f.goal_area, at(0.95, 0.1, angle)), 0.5, 1e-12) << angle;
  }
}

TEST(Coverage, IsAThirdWhereTheCentreIsJustInACorner) {
  const Field f = make_field(RobotLeague::small);
  ASSERT_TRUE(f.inside(f.goal_area, End::right, {0.605, 0.345}));
  const double inside = (0.0375 + 0.005) / side;
  EXPECT_NEAR(part(f, f.goal_area, at(0.605, 0.345)), inside * inside, 1e-12);
}

// Against counting points of a grid over the robot, anywhere around all areas of all leagues.
TEST(Coverage, AgreesWithCountedPoints) {
  Random random(5);
  for (const RobotLeague league : {RobotLeague::small, RobotLeague::middle, RobotLeague::large}) {
    const Field f = make_field(league);
    for (int i = 0; i < 200; ++i) {
      const Area& area = f.penalty_area && random.coin() ? *f.penalty_area : f.goal_area;
      const double front = f.half_length - area.depth;
      const Pose pose = at(random.uniform(front - 0.1, f.half_length + f.goal_depth),
                           random.uniform(-area.half_width - 0.1, area.half_width + 0.1),
                           random.uniform(-3.0, 3.0));
      constexpr int n = 60;
      int hits = 0;
      for (int k = 0; k < n * n; ++k) {
        const Vec2 offset{side * ((k % n + 0.5) / n - 0.5), side * ((k / n + 0.5) / n - 0.5)};
        const Vec2 point = pose.position + pose.heading.to_world(offset);
        hits += f.inside(area, End::right, point, 0.0) ? 1 : 0;
      }
      EXPECT_NEAR(part(f, area, pose), static_cast<double>(hits) / (n * n), 0.02)
          << to_string(league) << " " << pose.position.x() << " " << pose.position.y();
    }
  }
}

TEST(Coverage, IsTheSameAtBothEndsBitForBit) {
  Random random(6);
  const Field f = make_field(RobotLeague::large);
  for (int i = 0; i < 500; ++i) {
    const Pose pose =
        at(random.uniform(1.1, 2.1), random.uniform(-0.8, 0.8), random.uniform(-3, 3));
    const Pose turned{-pose.position, pose.heading.half_turned()};
    EXPECT_EQ(covered_part(f, *f.penalty_area, End::right, pose, side),
              covered_part(f, *f.penalty_area, End::left, turned, side));
  }
}

}  // namespace
}  // namespace mirocup::field
