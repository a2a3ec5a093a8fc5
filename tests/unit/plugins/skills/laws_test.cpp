// SPDX-License-Identifier: MIT
#include "mirocup/skills/laws.hpp"

#include "core/match/leg.hpp"
#include "tests/support/skill_field.hpp"

#include <gtest/gtest.h>

namespace mirocup::strategy {
namespace {

using test_support::SkillField;

// Drives robot 1 straight at the opponents' keeper; returns its greatest speed at less than 0.11 m.
double speed_at_keeper(Point ball_at) {
  SkillField field;
  field.put_robot({0.2, 0.0}, 0.0);
  double fastest = 0.0;
  for (int tick = 0; tick < 45; ++tick) {
    Observation now = field.observation();
    now.robots = 2;
    now.own[1] = field.robot();
    now.opponent[0] = {.x = 0.7, .y = 0.0, .heading = 0.0, .vx = 0.0, .vy = 0.0, .turn = 0.0};
    now.ball_x = ball_at.x;
    now.ball_y = ball_at.y;
    Command command{};
    command.wheels[1] = drive_to(field.setup(), now.own[1], {0.7, 0.0}, 1.5);
    spare_keeper(field.setup(), now, command);
    field.tick(command.wheels[1]);
    if (field.robot().x > 0.59) fastest = std::max(fastest, field.robot().vx);
  }
  return fastest;
}

// Catches a brake that comes too late for the motors: the law calls a touch at 0.5 m/s.
TEST(SpareKeeper, BrakesBeforeTheKeeper) {
  EXPECT_LT(speed_at_keeper({-0.5, 0.5}), 0.5);
}

// Catches rules that are told by "less than 0.02 s": VSSS, with 16 ms, got the distances of
// SimuroSot, though its laws protect no keeper.
TEST(SpareKeeper, KnowsTheRulesByTheirPeriod) {
  const SkillField field;
  mirocup_setup setup = field.setup();
  Observation now = field.observation();
  now.robots = 2;
  now.own[1] = {.x = 0.55, .y = 0.0, .heading = 0.0, .vx = 0.0, .vy = 0.0, .turn = 0.0};
  now.opponent[0] = {.x = 0.7, .y = 0.0, .heading = 0.0, .vx = 0.0, .vy = 0.0, .turn = 0.0};
  const auto speed = [&](referee::Preset preset) {
    setup.control_period = match::control_period_of(preset);
    Command command{};
    command.wheels[1] = wheels_for(setup, 1.0, 0.0);
    spare_keeper(setup, now, command);
    return setup.wheel_radius * command.wheels[1].left;
  };
  EXPECT_DOUBLE_EQ(speed(referee::Preset::vsss), 1.0);
  EXPECT_LT(speed(referee::Preset::mirosot), 0.6);
  EXPECT_LT(speed(referee::Preset::simurosot), speed(referee::Preset::mirosot));
}

}  // namespace
}  // namespace mirocup::strategy
