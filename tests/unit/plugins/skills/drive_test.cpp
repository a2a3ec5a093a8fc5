// SPDX-License-Identifier: MIT
#include "mirocup/skills/drive.hpp"

#include "tests/support/skill_field.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace mirocup::strategy {
namespace {

using test_support::SkillField;

// Plays a skill with the delay of a match. Returns the ticks until `is_done(robot)`, or `most`.
template <class Skill, class Done>
int ticks_until(SkillField& field, int most, const Skill& skill, const Done& is_done) {
  for (int tick = 0; tick < most; ++tick) {
    if (is_done(field.robot())) return tick;
    field.tick_later(skill(when_commanded(field.setup(), field.robot(), field.asked())));
  }
  return most;
}

bool is_at_rest(const Robot& robot) {
  return std::hypot(robot.vx, robot.vy) < 0.1 && std::abs(robot.turn) < 1.5;
}

// Catches a wrong sign or time constant: a robot is then centimetres from where it was expected.
TEST(WhenCommanded, IsWhereTheSimulatorPutsTheRobot) {
  SkillField field;
  field.put_robot({-0.3, 0.1}, 0.4);
  field.put_ball({0.6, -0.5});
  const Wheels commands[] = {{20.0, 30.0}, {60.0, 55.0}, {-10.0, 5.0}, {0.0, 0.0}};
  for (const Wheels& command : commands) {
    const Robot expected = when_commanded(field.setup(), field.robot(), command);
    field.tick(command);
    EXPECT_NEAR(expected.x, field.robot().x, 5e-4);
    EXPECT_NEAR(expected.y, field.robot().y, 5e-4);
    EXPECT_NEAR(wrapped(expected.heading - field.robot().heading), 0.0, 1e-3);
    EXPECT_NEAR(expected.turn, field.robot().turn, 0.05);
  }
}

// Catches a turn that swings past its heading and back, and one that creeps up to it.
TEST(TurnQuickly, EndsAtTheHeadingWithinAQuarterOfASecond) {
  for (const double heading : {0.3, 1.0, -pi / 2.0, 2.5, -3.0}) {
    SkillField field;
    field.put_robot({0.0, 0.0}, 0.0);
    field.put_ball({0.6, -0.5});
    const auto turn = [&](const Robot& r) { return turn_quickly(field.setup(), r, heading); };
    const auto done = [&](const Robot& r) {
      return std::abs(wrapped(heading - r.heading)) < 0.05 && is_at_rest(r);
    };
    EXPECT_LE(ticks_until(field, 60, turn, done), 11) << heading;
  }
}

// Catches a robot that runs past its place, or brakes long before it: from all sides, it is there
// sooner than with drive_to(), and stays.
TEST(DriveQuickly, IsThereSoonerThanDriveTo) {
  int quick = 0;
  int plain = 0;
  for (int start = 0; start < 12; ++start) {
    const double angle = start * pi / 6.0;
    const Point target{0.45 * std::cos(angle), 0.45 * std::sin(angle)};
    const auto done = [&](const Robot& r) {
      return length(target - position(r)) < 0.012 && is_at_rest(r);
    };
    SkillField field;
    field.put_ball({0.7, -0.6});
    field.put_robot({0.0, 0.0}, 1.0);
    quick += ticks_until(
        field, 90, [&](const Robot& r) { return drive_quickly(field.setup(), r, target); }, done);
    field.put_robot({0.0, 0.0}, 1.0);
    plain += ticks_until(
        field, 90, [&](const Robot& r) { return drive_to(field.setup(), r, target); }, done);
  }
  EXPECT_LT(quick, 12 * 22);
  EXPECT_LT(quick, 0.85 * plain);
}

// Catches a robot that forgets the heading, or turns all round where its tail would do.
TEST(TakePose, ArrivesWithTheHeading) {
  for (int start = 0; start < 8; ++start) {
    SkillField field;
    field.put_ball({0.7, -0.6});
    field.put_robot({-0.3, 0.2}, start * pi / 4.0);
    const Point target{0.2, -0.1};
    const auto take = [&](const Robot& r) { return take_pose(field.setup(), r, target, 0.8); };
    const auto done = [&](const Robot& r) {
      return length(target - position(r)) < 0.015 && std::abs(std::sin(r.heading - 0.8)) < 0.06 &&
             is_at_rest(r);
    };
    EXPECT_LT(ticks_until(field, 90, take, done), 40) << start;
  }
}

// Catches wheels that are both too fast, of which the slower one is cut off and the curve changes.
TEST(WheelsTurningFirst, KeepWithinTheLimitAndTurnAsAsked) {
  const SkillField field;
  const auto& setup = field.setup();
  for (const double turn : {-30.0, 10.0, 50.0}) {
    const Wheels w = wheels_turning_first(setup, 1.8, turn);
    EXPECT_LE(std::max(std::abs(w.left), std::abs(w.right)), setup.wheel_speed_limit + 1e-9);
    EXPECT_NEAR(setup.wheel_radius * (w.right - w.left) / setup.wheel_distance, turn, 1e-9);
  }
}

}  // namespace
}  // namespace mirocup::strategy
