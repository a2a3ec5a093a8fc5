// SPDX-License-Identifier: MIT
//
// Single statements about worlds. Whole scenes are in tests/physics, finds of long runs in
// tests/scenes/found.
#include "core/simulator/world.hpp"

#include "tests/support/exact_motion.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace mirocup::simulator {
namespace {

// The faster the angular velocity changes, the slower the series converge. Catches a segment over
// which its series have not converged.
TEST(World, RobotThatReversesItsTurnFollowsTheExactMotion) {
  Parameters parameters;
  parameters.grip = infinite_grip;
  for (const double turn : {8.0, 20.0, 50.0}) {
    const BodyState start{{0.0, 0.0}, {}, {1.0, 0.0, turn}};
    const double u = -turn * parameters.wheel_distance / (2.0 * parameters.wheel_radius);
    const WheelCommand reversed = WheelSpeeds{-u, u};
    World world(nullptr, parameters, Tolerances{}, 1, false);
    world.set_robot(0, start);
    world.advance({&reversed, 1}, 0.033);
    const BodyState exact = test_support::rounded(
        test_support::drive_exactly(parameters, test_support::exactly(start), reversed, 0.033L));
    EXPECT_LE((world.robot(0).position - exact.position).norm(), 1e-12) << turn;
    EXPECT_NEAR(world.robot(0).heading.sin, exact.heading.sin, 1e-12) << turn;
  }
}

// Wheels of infinite grip hold nothing while they are off the ground; put down, they hold at once.
TEST(World, LiftedRobotSlidesAtAnyGripAndStopsWhenPutDown) {
  Parameters parameters;
  parameters.grip = infinite_grip;
  World world(nullptr, parameters, Tolerances{}, 1, false);
  world.set_robot(0, {{0.0, 0.0}, {}, {0.0, 0.5, 6.0}});
  const WheelCommand lifted;
  world.advance({&lifted, 1}, 0.1);
  EXPECT_NEAR((world.robot(0).position - Vec2{0.0, 0.05}).norm(), 0.0, 1e-12);
  EXPECT_NEAR((world.robot(0).velocity() - Vec2{0.0, 0.5}).norm(), 0.0, 1e-12);
  const WheelCommand standing = WheelSpeeds{};
  world.advance({&standing, 1}, 0.1);
  EXPECT_EQ(world.robot(0).twist.left, 0.0);
}

// Catches a rebound that is taken for rest because it is slow.
TEST(World, ReboundAtATenthOfAMillimetrePerSecondIsNotTakenForRest) {
  const field::Field field = field::make_field(RobotLeague::small);
  Parameters parameters;
  parameters.restitution.ball_wall = 1e-4;
  parameters.rolling_resistance = 0.0;
  parameters.viscous_friction = 0.0;
  World world(&field, parameters, Tolerances{}, 0, true);
  for (const double side : {-1.0, 1.0}) {
    world.set_ball({{0.0, side * (field.half_width - 0.05)}, {0.0, side * 1.0}});
    EXPECT_EQ(world.advance({}, 0.033).impacts, 1);
    EXPECT_NEAR(world.ball().velocity.y(), -side * 1e-4, 1e-12);
  }
}

// Mirror images that press a ball between them: what rounding leaves sideways grows with each
// term of the ball's series from its turning point on. Catches a curve that is as long as it
// stays small.
TEST(World, BallPinchedByMirrorImagesStaysOnTheAxis) {
  Parameters parameters;
  parameters.restitution.ball_robot = 0.10662284917722653;
  World world(nullptr, parameters, Tolerances{}, 2, true);
  const Heading heading = Heading::from_angle(-0.20089410070816699);
  world.set_robot(
      0, {{0.0, 0.067858439702832701}, heading, {0.15426211078335478, 0.0, -1.5341704755924441}});
  world.set_robot(1, {{0.0, -0.067858439702832701},
                      {heading.cos, -heading.sin},
                      {0.15426211078335478, 0.0, 1.5341704755924441}});
  world.set_ball({{-0.2, 0.0}, {3.8793614464732951, 0.0}});
  const std::array<WheelCommand, 2> commands{WheelSpeeds{34.604004210975262, -22.411810073882403},
                                             WheelSpeeds{-22.411810073882403, 34.604004210975262}};
  for (int tick = 0; tick < 5; ++tick) {
    world.advance(commands, 0.033);
    EXPECT_NEAR(world.ball().position.y(), 0.0, 1e-10) << tick;
    EXPECT_NEAR(world.robot(0).heading.sin, -world.robot(1).heading.sin, 1e-9) << tick;
  }
}

// A goal post's corner in a robot's side: the post is the point's side of that contact, and no
// body. Catches a correction that moves "body -1", which is the memory before the bodies.
TEST(World, PostPushesAnOverlappingRobotOutAndChangesNoMasses) {
  const field::Field field = field::make_field(RobotLeague::small);
  const Parameters parameters;
  World world(&field, parameters, Tolerances{}, 1, false);
  const double overlap = 1e-6;
  const double diagonal = std::sqrt(0.5);
  const Vec2 outwards{-diagonal, -diagonal};
  const Vec2 post{field.half_length, field.goal_half_width};
  const double reach = parameters.robot_side / 2.0 - overlap;
  const BodyState start{post + reach * outwards, {diagonal, diagonal}, {}};
  world.set_robot(0, start);
  const solver::InverseMass before = world.static_world().grounded_robot;
  const WheelCommand standing = WheelSpeeds{};
  world.advance({&standing, 1}, 0.033);
  EXPECT_NEAR(outwards.dot(world.robot(0).position - start.position), overlap, 1e-9);
  EXPECT_EQ(world.static_world().grounded_robot.forward, before.forward);
  EXPECT_EQ(world.static_world().grounded_robot.left, before.left);
  EXPECT_EQ(world.static_world().grounded_robot.omega, before.omega);
}

// A robot that walls with friction wedge: wheels and walls hold it from all sides. Catches a
// contact that seems to slide by rounding, stops, and slides again, without end at `coarse`.
TEST(World, WedgedRobotSticksAtEveryLevel) {
  const field::Field field = field::make_field(RobotLeague::small);
  Parameters parameters;
  parameters.contact_friction.robot_wall = 0.3;
  const WheelCommand command = WheelSpeeds{29.504676389409983, 44.126343720939829};
  for (const Accuracy level : {Accuracy::coarse, Accuracy::standard}) {
    World world(&field, parameters, tolerances_of(level), 1, false);
    world.set_robot(0, {{0.70305351361844615, 0.55533144276592972},
                        {0.9548672482055105, 0.29703289094717439},
                        {}});
    for (int k = 0; k < 3; ++k) EXPECT_LE(world.advance({&command, 1}, 0.033).events, 40);
  }
}

}  // namespace
}  // namespace mirocup::simulator
