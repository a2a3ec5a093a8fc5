// SPDX-License-Identifier: MIT
#include "mirocup/skills/laws.hpp"

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

}  // namespace
}  // namespace mirocup::strategy
