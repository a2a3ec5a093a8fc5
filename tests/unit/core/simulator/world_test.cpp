// SPDX-License-Identifier: MIT
//
// Small facts about worlds; whole scenes are in tests/scenes.
#include "core/simulator/world.hpp"

#include "tests/support/exact_motion.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace mirocup::simulator {
namespace {

// The sharper a turn changes, the slower its series converge. Catches a segment that is longer than
// its series are good for.
TEST(World, RobotsAreExactWhenTheirTurnIsReversed) {
  Parameters parameters;
  parameters.grip = infinite_grip;
  for (const double turn : {8.0, 20.0, 50.0}) {
    const RobotState start{{0.0, 0.0}, {}, {1.0, 0.0, turn}};
    const double u = -turn * parameters.wheel_distance / (2.0 * parameters.wheel_radius);
    const WheelCommand reversed = WheelSpeeds{-u, u};
    World world(nullptr, parameters, Tolerances{}, 1, false);
    world.set_robot(0, start);
    world.advance({&reversed, 1}, 0.033);
    const RobotState exact = test_support::rounded(
        test_support::drive_exactly(parameters, test_support::exactly(start), reversed, 0.033L));
    EXPECT_LE((world.robot(0).position - exact.position).norm(), 1e-12) << turn;
    EXPECT_NEAR(world.robot(0).heading.sin, exact.heading.sin, 1e-12) << turn;
  }
}

// Wheels of infinite grip hold nothing while they are off the ground; put down, they hold at once.
TEST(World, LiftedRobotsSlideWhateverTheGrip) {
  Parameters parameters;
  parameters.grip = infinite_grip;
  World world(nullptr, parameters, Tolerances{}, 1, false);
  world.set_robot(0, {{0.0, 0.0}, {}, {0.0, 0.5, 0.0}});
  const WheelCommand lifted;
  world.advance({&lifted, 1}, 0.1);
  EXPECT_NEAR(world.robot(0).position.y(), 0.05, 1e-15);
  EXPECT_EQ(world.robot(0).twist.left, 0.5);
  const WheelCommand standing = WheelSpeeds{};
  world.advance({&standing, 1}, 0.1);
  EXPECT_NEAR(world.robot(0).position.y(), 0.05, 1e-15);
  EXPECT_EQ(world.robot(0).twist.left, 0.0);
}

// A goal post's corner in a robot's side: the post is the point's side of that contact, and no
// body. Catches a correction that moves "body -1", which is the memory before the bodies.
TEST(World, PostsPushRobotsOutAndNothingElse) {
  const field::Field field = field::make_field(League::small);
  const Parameters parameters;
  World world(&field, parameters, Tolerances{}, 1, false);
  const double overlap = 1e-6;
  const double diagonal = std::sqrt(0.5);
  const Vec2 outwards{-diagonal, -diagonal};
  const Vec2 post{field.half_length, field.goal_half_width};
  const double reach = parameters.robot_side / 2.0 - overlap;
  const RobotState start{post + reach * outwards, {diagonal, diagonal}, {}};
  world.set_robot(0, start);
  const InverseMass before = world.arena().grounded_robot;
  const WheelCommand standing = WheelSpeeds{};
  world.advance({&standing, 1}, 0.033);
  EXPECT_NEAR(outwards.dot(world.robot(0).position - start.position), overlap, 1e-9);
  EXPECT_EQ(world.arena().grounded_robot.forward, before.forward);
  EXPECT_EQ(world.arena().grounded_robot.left, before.left);
  EXPECT_EQ(world.arena().grounded_robot.turn, before.turn);
}

}  // namespace
}  // namespace mirocup::simulator
