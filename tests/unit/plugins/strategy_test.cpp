// SPDX-License-Identifier: MIT
//
// Tests the parts of strategy.hpp that no game of a house team would test.
#include "mirocup/strategy.hpp"

#include "core/match/leg.hpp"
#include "plugins/abi/convert.hpp"
#include "tests/support/skill_field.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <iterator>
#include <limits>
#include <string>

namespace mirocup::strategy {
namespace {

TEST(WrappedAngle, IsTheSameDirectionInOneTurn) {
  for (int i = -700; i <= 700; ++i) {
    const double angle = 0.01 * i;
    const double w = wrapped(angle);
    EXPECT_GT(w, -pi) << angle;
    EXPECT_LE(w, pi) << angle;
    EXPECT_NEAR(std::cos(w), std::cos(angle), 1e-14) << angle;
    EXPECT_NEAR(std::sin(w), std::sin(angle), 1e-14) << angle;
  }
  EXPECT_EQ(wrapped(pi), pi);
  EXPECT_EQ(wrapped(-pi), pi);
  EXPECT_EQ(wrapped(2.0 * pi), 0.0);
  EXPECT_EQ(wrapped(0.5), 0.5);
}

// Catches a loop that subtracts one turn at a time: at 1e16 the subtraction changes nothing, and
// the team hangs.
TEST(WrappedAngle, EndsForHugeAndInfiniteAngles) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (const double angle : {1e9, -1e16, 1e17, -1e300, std::numeric_limits<double>::max()}) {
    EXPECT_GT(wrapped(angle), -pi) << angle;
    EXPECT_LE(wrapped(angle), pi) << angle;
  }
  EXPECT_TRUE(std::isnan(wrapped(infinity)));
  EXPECT_TRUE(std::isnan(wrapped(-infinity)));
  EXPECT_TRUE(std::isnan(wrapped(std::nan(""))));
}

// Catches the count of one law at the index of another, and a law that the host does not count but
// that seems to be broken from the first tick on.
TEST(LawsOfATeam, HaveCountsAndLimitsAtTheirIndexes) {
  match::Setup leg;
  leg.rules.def_dwell_s = 1.0;
  leg.rules.att_dwell_s = 2.0;
  leg.rules.keeper_hold_s = 3.0;
  leg.rules.def_max = 1;
  leg.rules.pa_def_max = 2;
  leg.rules.att_max = 3;
  const field::Field field = field::make_field(RobotLeague::middle);
  const mirocup_setup setup =
      abi::to_setup({.field = &field, .parameters = &leg.parameters, .rules = &leg.rules});
  match::Observation seen;
  seen.own_counts = {.defenders = 4,
                     .two_defenders_s = 0.4,
                     .area_defenders = 5,
                     .four_defenders_s = 0.5,
                     .attackers = 6,
                     .two_attackers_s = 0.6,
                     .keeper_hold_s = 0.7,
                     .keeper = 2,
                     .advantage_against = true};
  const mirocup_observation now = abi::to_observation(seen);
  const double limits[] = {1.0, 1.0, 2.0, 3.0}, times[] = {0.4, 0.5, 0.6, 0.7};
  const int allowed[] = {1, 2, 3, 0}, robots[] = {4, 5, 6, 0};
  ASSERT_EQ(setup.laws, std::ssize(limits));
  ASSERT_EQ(now.laws, setup.laws);
  for (int law = 0; law < setup.laws; ++law) {
    EXPECT_EQ(setup.time_limit_s[law], limits[law]) << law;
    EXPECT_EQ(setup.robots_allowed[law], allowed[law]) << law;
    EXPECT_EQ(now.own_counts.time_s[law], times[law]) << law;
    EXPECT_EQ(now.own_counts.robots[law], robots[law]) << law;
    EXPECT_EQ(now.opponent_counts.time_s[law], 0.0) << law;
  }
  for (int law = setup.laws; law < MIROCUP_MAX_LAWS; ++law) {
    EXPECT_EQ(setup.time_limit_s[law], referee::off) << law;
    EXPECT_EQ(now.own_counts.time_s[law], 0.0) << law;
  }
  EXPECT_EQ(now.own_counts.keeper, 2);
  EXPECT_EQ(now.own_counts.advantage_against, 1);
}

std::string last_line;

class Talker : public Team {
 public:
  using Team::Team;
  void decide(const Observation& now, Command&) override {
    log("50% of what is said, %d and %s");
    EXPECT_EQ(last_line, "50% of what is said, %d and %s");
    log("tick %u, ball at %.2f, %s", now.tick, now.ball_x, "so far");
    EXPECT_EQ(last_line, "tick 7, ball at 0.25, so far");
    log("%s", std::string(1000, 'x').c_str());
    EXPECT_EQ(last_line, std::string(255, 'x'));
  }
};

TEST(TeamInCpp, FormatsItsLogOnlyIfThereAreValues) {
  mirocup_setup setup{};
  setup.size = sizeof setup;
  setup.log = [](void*, const char* text) { last_line = text; };
  Observation now{};
  now.tick = 7;
  now.ball_x = 0.25;
  Command command{};
  Talker(setup).decide(now, command);
}

// Catches distances of the usual robot of 75 mm on a pitch with larger ones.
TEST(Sizes, AreThoseOfTheRobotsOfTheLeg) {
  mirocup_setup setup = test_support::SkillField().setup();
  Observation now{};
  now.robots = 1;
  now.ball_x = now.ball_y = 0.5;
  now.opponent[0].x = 0.3;
  now.opponent[0].y = 0.1;
  const Robot robot{};
  const Wheels ahead = wheels_for(setup, 1.0, 0.0);
  EXPECT_EQ(without_pushing(setup, now, robot, ahead).left, ahead.left);
  Robot beside_ball{};
  beside_ball.x = now.ball_x - 0.08;
  beside_ball.y = now.ball_y;
  EXPECT_GT(free_ball(setup, now, beside_ball).left, 0.0);
  EXPECT_GT(free_ball(setup, now, beside_ball).right, 0.0);

  setup.robot_side = 0.1;
  EXPECT_LT(without_pushing(setup, now, robot, ahead).left, ahead.left);
  EXPECT_EQ(free_ball(setup, now, beside_ball).left, -free_ball(setup, now, beside_ball).right);
}

// Catches a robot that drives through its own goal area on the way to a legal place, which gives
// the opponents a penalty kick, and one that would stop inside.
TEST(OutOfArea, TurnsARobotThatWouldEnterTheOwnGoalArea) {
  for (const Point start : {Point{-0.35, 0.0}, Point{-0.66, 0.55}, Point{-0.66, -0.55}}) {
    test_support::SkillField field;
    field.put_ball({0.5, 0.5});
    field.put_robot(start, start.y == 0.0 ? pi : -start.y / std::abs(start.y) * pi / 2.0);
    for (int tick = 0; tick < 60; ++tick) {
      const Robot robot = field.robot();
      const Wheels into = drive_to(field.setup(), robot, {-0.7, 0.0}, 1.5);
      field.tick(out_of_area(field.setup(), 1, robot, into));
      const mirocup_setup& setup = field.setup();
      EXPECT_FALSE(field.robot().x < -setup.half_length + setup.goal_area_depth &&
                   std::abs(field.robot().y) < setup.goal_area_half_width)
          << field.robot().x << ", " << field.robot().y << " from " << start.x << ", " << start.y
          << ", tick " << tick;
    }
  }
}

// Catches a keeper that an attacker pushes inwards with the ball along the end wall: a keeper at
// its place did not drive, and a ball that was pressed against it went in past the near post.
TEST(KeepGoal, PushesABallAtTheEndWallOutwards) {
  test_support::SkillField field;
  const mirocup_setup& setup = field.setup();
  const double line = -setup.half_length + 0.4 * setup.robot_side;
  for (const double side : {-1.0, 1.0}) {
    const Point at{line, side * (setup.goal_half_width - 0.04)};
    field.put_robot(at, pi / 2.0);
    field.put_ball({-setup.half_length + 0.022, at.y + side * 0.06});
    const Wheels outwards = keep_goal(setup, field.observation(), field.robot());
    EXPECT_GT(side * outwards.left * setup.wheel_radius, 1.5) << side;
    EXPECT_GT(side * outwards.right * setup.wheel_radius, 1.5) << side;
    field.put_robot({at.x, side * (setup.goal_half_width - 0.01)}, pi / 2.0);
    field.put_ball({-setup.half_length + 0.022, side * (setup.goal_half_width + 0.05)});
    const Wheels at_post = keep_goal(setup, field.observation(), field.robot());
    EXPECT_LT(side * at_post.left, 0.0) << "past the post, " << side;
  }
}

// Catches a kick-off that plays the ball forwards, which is a foul, from behind the ball or beside
// it, and a robot that stays beside its way round the ball, or is late. A law that is off binds no
// robot.
TEST(KickOff, RollsTheBallHomeInTimeFromAnyPlace) {
  for (const RobotLeague league : {RobotLeague::small, RobotLeague::middle}) {
    for (int start = 0; start < 6 * 6 * 5; ++start) {
      test_support::SkillField field(league);
      const Point at{0.12 * (start % 6) - 0.3, 0.12 * (start / 6 % 6) - 0.31};
      if (length(at) < 0.08) continue;
      field.put_ball({0.0, 0.0});
      field.put_robot(at, 1.3 * (start / 36));
      for (int tick = 0; tick < 150 && length(field.ball()) < 0.05; ++tick)
        field.tick_later(kick_off(field.setup(), field.robot()));
      EXPECT_LT(field.ball().x, 0.0) << at.x << ", " << at.y << ", " << start;
    }
  }
  mirocup_setup setup = test_support::SkillField().setup();
  setup.time_limit_s[MIROCUP_KEEPER_HOLD] = std::numeric_limits<double>::infinity();
  EXPECT_GT(kick_off(setup, {-0.08, 0.0, 0.0, 0.0, 0.0, 0.0}).left, 0.0);
}

}  // namespace
}  // namespace mirocup::strategy
