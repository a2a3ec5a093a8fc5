// SPDX-License-Identifier: MIT
//
// The yardstick itself, held against closed forms: catches an integrator whose error does not fall
// with its step, and one that agrees with the simulator because it makes the same mistake.
#include "tests/physics/scene.hpp"
#include "tests/support/tiny_world.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace mirocup::scenes {
namespace {

using namespace test_support;

// Straight on from rest: v = v_ref (1 - e^(-t/T)) and its integral.
TEST(ExactMotion, StraightOnIsTheExponential) {
  const Parameters p;
  const ExactRobot r = drive_exactly(p, {}, WheelSpeeds{40.0, 40.0}, 0.5L);
  const long double T = p.motor_time_constant;
  const long double v = p.wheel_radius * 40.0L;
  const long double rest = std::exp(-0.5L / T);
  EXPECT_NEAR(static_cast<double>(r.forward - v * (1 - rest)), 0.0, 1e-16);
  EXPECT_NEAR(static_cast<double>(r.x - v * (0.5L - T * (1 - rest))), 0.0, 1e-16);
}

// Told to stand, a robot whose motors brake goes on by v T_brake, and turns by omega T_turn.
TEST(ExactMotion, EachLagHasItsOwnWay) {
  Parameters p;
  p.grip = simulator::infinite_grip;
  p.turn_time_constant = 0.13;
  p.brake_time_constant = 0.0145;
  ExactRobot straight;
  straight.forward = 1.2L;
  straight = drive_exactly(p, straight, WheelSpeeds{0.0, 0.0}, 2.0L);
  EXPECT_NEAR(static_cast<double>(straight.x), 1.2 * 0.0145, 1e-16);
  ExactRobot spinning;
  spinning.turn = 9.0L;
  spinning = drive_exactly(p, spinning, WheelSpeeds{0.0, 0.0}, 5.0L);
  EXPECT_NEAR(static_cast<double>(spinning.angle), 9.0 * 0.13, 1e-15);
  ExactRobot drives;
  drives = drive_exactly(p, drives, WheelSpeeds{40.0, 40.0}, 0.5L);
  const long double rest = std::exp(-0.5L / p.motor_time_constant);
  EXPECT_NEAR(static_cast<double>(drives.forward - p.wheel_radius * 40.0L * (1 - rest)), 0.0, 1e-16)
      << "the brake acts at zero command only";
}

// At constant speeds the robot goes round a circle.
TEST(ExactMotion, ConstantSpeedsAreACircle) {
  Parameters p;
  p.grip = simulator::infinite_grip;
  const double turn = p.wheel_radius * 20.0 / p.wheel_distance;
  const double speed = p.wheel_radius * 30.0;
  ExactRobot r;
  r.forward = speed;
  r.turn = turn;
  r = drive_exactly(p, r, WheelSpeeds{20.0, 40.0}, 2.0L);
  EXPECT_NEAR(static_cast<double>(r.x), speed / turn * std::sin(2.0 * turn), 1e-14);
  EXPECT_NEAR(static_cast<double>(r.y), speed / turn * (1.0 - std::cos(2.0 * turn)), 1e-14);
}

// A robot pushed sideways slides v^2 / (2 grip g) far and stays there.
TEST(ExactMotion, ASlideEndsWhereItsEnergyEnds) {
  const Parameters p;
  ExactRobot r;
  r.left = 0.5L;
  r = drive_exactly(p, r, WheelSpeeds{}, 1.0L);
  EXPECT_NEAR(static_cast<double>(r.y), 0.25 / (2.0 * p.grip * 9.81), 1e-16);
  EXPECT_EQ(static_cast<double>(r.left), 0.0);
}

// The error of a robot alone, of a turn hard enough to slide.
double error_alone(double step) {
  const Parameters p;
  const BodyState start{{0.0, 0.0}, {}, {1.5, 0.0, 10.0}};
  const WheelCommand command = WheelSpeeds{0.0, 60.0};
  TinyWorld world(nullptr, p, 1, false, step);
  world.set_robot(0, start);
  world.advance({&command, 1}, 0.1);
  return difference(world.robot(0),
                    test_support::rounded(drive_exactly(p, exactly(start), command, 0.1L)));
}

// The tiny steps know the same motors.
TEST(TinyWorld, BrakesAndTurnsWithLagsOfTheirOwn) {
  const Parameters p = with(other_motors[std::size(other_motors) - 1]);
  const BodyState start{{0.0, 0.0}, {}, {0.8, 0.0, 5.0}};
  for (const WheelCommand command : {WheelSpeeds{0.0, 0.0}, WheelSpeeds{10.0, 20.0}}) {
    TinyWorld world(nullptr, p, 1, false, 2e-5);
    world.set_robot(0, start);
    world.advance({&command, 1}, 0.1);
    const BodyState exact = test_support::rounded(drive_exactly(p, exactly(start), command, 0.1L));
    EXPECT_LT(difference(world.robot(0), exact), 1e-7);
    EXPECT_LT(velocity_difference(world.robot(0), exact), 1e-6);
  }
}

TEST(TinyWorld, HalvingTheStepQuartersTheErrorOfAFreeRobot) {
  const double coarse = error_alone(2e-4);
  const double fine = error_alone(5e-5);
  EXPECT_LT(coarse, 1e-5);
  EXPECT_LT(fine, coarse / 10.0) << "two halvings";
}

// A robot that pushes another one straight ahead: one mass, two motors.
TEST(TinyWorld, TwoRobotsInARowAreOneBody) {
  const Parameters p;
  for (const double step : {1e-4, 2.5e-5}) {
    TinyWorld world(nullptr, p, 2, false, step);
    world.set_robot(0, {{0.0, 0.0}, {}, {}});
    world.set_robot(1, {{p.robot_side, 0.0}, {}, {}});
    const WheelCommand commands[] = {WheelSpeeds{40.0, 40.0}, WheelSpeeds{20.0, 20.0}};
    world.advance(commands, 0.2);
    // Both motors together aim at the mean speed.
    const double T = p.motor_time_constant;
    const double way = p.wheel_radius * 30.0 * (0.2 - T * (1.0 - std::exp(-0.2 / T)));
    EXPECT_NEAR(world.robot(0).position.x(), way, 2.0 * step * step + 1e-9) << step;
    EXPECT_NEAR(world.robot(1).position.x(), way + p.robot_side, 2.0 * step * step + 1e-9) << step;
  }
}

// A ball against a wall: one impact, in closed form.
TEST(TinyWorld, FindsTheTimeOfAnImpact) {
  const field::Field field = field::make_field(RobotLeague::small);
  Parameters p = without_rolling_friction();
  TinyWorld world(&field, p, 0, true, 1e-4);
  world.set_ball({{0.0, 0.5}, {0.0, 2.0}});
  world.advance({}, 0.2);
  const double wall = field.half_width - p.ball_radius;
  const double left = 0.2 - (wall - 0.5) / 2.0;
  EXPECT_EQ(world.impacts(), 1);
  EXPECT_NEAR(world.ball().position.y(), wall - p.restitution.ball_wall * 2.0 * left, 1e-7);
}

// A ball that is held between a robot and a wall stays there.
TEST(TinyWorld, APinchedBallRests) {
  const field::Field field = field::make_field(RobotLeague::small);
  const Parameters p;
  TinyWorld world(&field, p, 1, true, 1e-4);
  world.set_robot(0, {{0.0, 0.56}, Heading::from_angle(pi / 2), {}});
  world.set_ball({{0.0, field.half_width - p.ball_radius}, {0.0, 0.0}});
  const WheelCommand ahead = WheelSpeeds{30.0, 30.0};
  world.advance({&ahead, 1}, 0.5);
  EXPECT_LE(world.ball().velocity.norm(), 1e-6);
  EXPECT_LE(world.robot(0).twist.forward, 1e-6);
  EXPECT_LE(world.deepest_overlap(), 1e-7);
}

TEST(Outline, DistancesAreEuclidean) {
  using test_support::circle_at;
  using test_support::distance;
  using test_support::square_at;
  const auto square = square_at({0.0, 0.0}, 0.0, 2.0);
  EXPECT_NEAR(distance(circle_at({4.0, 5.0}, 1.0), square), 4.0, 1e-15) << "a corner";
  EXPECT_NEAR(distance(circle_at({0.0, 3.0}, 1.0), square), 1.0, 1e-15) << "an edge";
  EXPECT_NEAR(distance(circle_at({0.0, 1.5}, 1.0), square), -0.5, 1e-15) << "inside";
  EXPECT_NEAR(distance(square_at({5.0, 6.0}, 0.0, 2.0), square), 5.0, 1e-15) << "two corners";
  EXPECT_NEAR(distance(square_at({3.0, 0.0}, pi / 4, 2.0), square), 2.0 - std::sqrt(2.0), 1e-15)
      << "corner and edge";
  EXPECT_EQ(touch_points(square_at({2.0, 0.5}, 0.0, 2.0), square, 1e-9).size(), 2u) << "flush";
}

}  // namespace
}  // namespace mirocup::scenes
