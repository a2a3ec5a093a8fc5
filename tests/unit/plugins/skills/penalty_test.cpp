// SPDX-License-Identifier: MIT
#include "mirocup/skills/penalty.hpp"

#include "tests/support/skill_field.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace mirocup::strategy {
namespace {

using test_support::SkillField;

// Takes a penalty while the opponents' keeper is at `keeper_y` from the moment on in which the run
// begins. Returns where the ball crosses the goal line, m; NaN if it does not within two seconds.
double penalty_crossing(double keeper_y) {
  SkillField field;
  const Point spot{0.375, 0.0};
  field.put_ball(spot);
  PenaltyTaker taker;
  const mirocup_pose start = taker.stand(field.setup(), field.observation(), -0.01);
  field.put_robot({start.x, start.y}, start.heading);
  for (int tick = 0; tick < 60; ++tick) {
    Observation now = field.observation();
    now.opponent[0].y = keeper_y;
    const bool is_taken = length(field.ball() - spot) > 0.01;
    const Robot soon = when_commanded(field.setup(), now.own[0], field.asked());
    field.tick_later(is_taken ? Wheels{} : taker.drive(field.setup(), now, soon));
    if (field.ball().x >= field.setup().half_length) return field.ball().y;
  }
  return std::nan("");
}

// Catches a kicker that shoots into the corner in which a keeper that read its run-up stands, and
// one that turns for a keeper that stays where it is.
TEST(Penalty, GoesWhereTheKeeperDoesNot) {
  const double goal = SkillField().setup().goal_half_width;
  const double run_up_side = penalty_crossing(0.0);
  EXPECT_GT(run_up_side, 0.05);
  EXPECT_LT(run_up_side, goal);
  const double keeper = 0.1;
  const double other_side = penalty_crossing(keeper);
  EXPECT_LT(other_side, keeper - 0.07);  // past its side, with the ball's radius
  EXPECT_GT(other_side, -goal);
}

}  // namespace
}  // namespace mirocup::strategy
