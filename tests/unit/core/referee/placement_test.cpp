// SPDX-License-Identifier: MIT
//
// Catches poses that overlap, stand in walls or break the placement rules of their restart.
#include "core/referee/placement.hpp"

#include "core/geometry/outline.hpp"
#include "core/geometry/separation.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace mirocup::referee {
namespace {

struct Case {
  RobotLeague league;
  Restart restart;
  End taker;
  Vec2 spot;
  bool behind = false;  // the kicker at a kick-off, as in vsss
};

std::vector<Case> all_cases() {
  std::vector<Case> cases;
  for (const RobotLeague league : {RobotLeague::small, RobotLeague::middle, RobotLeague::large}) {
    const field::Field field = field::make_field(league);
    for (const End taker : both_ends) {
      for (const Restart restart :
           {Restart::KICK_OFF, Restart::GOAL_KICK, Restart::PENALTY_KICK, Restart::FREE_KICK}) {
        cases.push_back({league, restart, taker, {0.0, 0.0}});
      }
      cases.push_back({league, Restart::KICK_OFF, taker, {0.0, 0.0}, true});
    }
    for (const double x : {-1.0, 1.0}) {
      for (const double y : {-1.0, 1.0}) {
        const Vec2 spot{x * field.free_ball_mark.x(), y * field.free_ball_mark.y()};
        cases.push_back({league, Restart::FREE_BALL, x > 0.0 ? End::right : End::left, spot});
      }
    }
  }
  return cases;
}

class DefaultPlacement : public testing::TestWithParam<Case> {
 protected:
  DefaultPlacement()
      : field_(field::make_field(GetParam().league)),
        placed_(placed(GetParam().behind ? Preset::vsss : Preset::mirosot)) {}

  Placement placed(Preset preset) const {
    const Rules rules = make_rules(preset);
    return default_placement({field_, rules, 0.02135, 0.075}, GetParam().restart, GetParam().taker,
                             GetParam().spot);
  }

  // In the taker's frame.
  Vec2 own(int i) const { return at(GetParam().taker, i); }
  Vec2 opponent(int i) const { return at(opposite(GetParam().taker), i); }
  Vec2 ball() const { return team_frame(GetParam().taker, placed_.ball); }

  Vec2 at(End end, int i) const {
    return team_frame(GetParam().taker, placed_.robots[index_of(end)][i].position);
  }

  field::Field field_;
  Placement placed_;
};
INSTANTIATE_TEST_SUITE_P(All, DefaultPlacement, testing::ValuesIn(all_cases()));

TEST_P(DefaultPlacement, OverlapsNothing) {
  const geometry::Outline robot = geometry::square(0.075);
  const geometry::Outline ball = geometry::circle(0.02135);
  std::vector<Pose> bodies;
  for (const End end : both_ends) {
    for (int i = 0; i < field_.robots_per_team; ++i) {
      const Pose& pose = placed_.robots[index_of(end)][i];
      bodies.push_back(pose);
      for (const field::Wall& wall : field_.walls) {
        EXPECT_GE(geometry::gap(robot, bodies.back(), wall), 0.0) << i;
      }
      EXPECT_GE(field_.clearance(pose.position), 0.0375) << i;
    }
  }
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      EXPECT_GE(geometry::gap(robot, bodies[i], robot, bodies[j]), 0.004) << i << " " << j;
    }
    EXPECT_GT(geometry::gap(ball, Pose{placed_.ball, {}}, robot, bodies[i]), 0.0) << i;
  }
}

TEST_P(DefaultPlacement, KeepsTheRuleOfItsRestart) {
  const double half = 0.0375;
  const int n = field_.robots_per_team;
  switch (GetParam().restart) {
    case Restart::none:
      break;
    case Restart::KICK_OFF:
      for (int i = 0; i < n; ++i) {
        EXPECT_TRUE(own(i).x() <= -half || own(i).norm() < field_.centre_circle_radius) << i;
        EXPECT_GE(opponent(i).x(), half) << i;
        EXPECT_GE(opponent(i).norm() - half, field_.centre_circle_radius) << i;
      }
      EXPECT_EQ(own(1), (Vec2{GetParam().behind ? -0.08 : 0.08, 0.0}));
      break;
    case Restart::PENALTY_KICK:
      EXPECT_NEAR(ball().x(), field_.penalty_mark_x, 1e-12);
      EXPECT_LT(own(1).x(), ball().x()) << "the kicker is behind the ball";
      EXPECT_NEAR(opponent(0).x(), field_.half_length - half, 1e-12) << "the keeper is on its line";
      for (int i = 0; i < n; ++i) {
        if (i != 1) {
          EXPECT_LE(own(i).x(), -half) << i;
        }
        if (i != 0) {
          EXPECT_LE(opponent(i).x(), -half) << i;
        }
      }
      break;
    case Restart::FREE_KICK:
      EXPECT_NEAR(ball().x(), field_.penalty_mark_x, 1e-12);
      EXPECT_LT(own(1).x(), ball().x()) << "the kicker is behind the ball";
      EXPECT_TRUE(field_.inside(field_.goal_area, End::right, opponent(0)));
      for (int i = 0; i < n; ++i) {
        if (i != 1) {
          EXPECT_LE(own(i).x(), -half) << i;
        }
        EXPECT_GE(opponent(i).x(), half) << i;
      }
      break;
    case Restart::GOAL_KICK:
      EXPECT_TRUE(field_.inside(field_.goal_area, GetParam().taker, placed_.ball));
      for (int i = 0; i < n; ++i) {
        EXPECT_GE(opponent(i).x(), half) << i;
        const field::Area& area = field_.penalty_area.value_or(field_.goal_area);
        if (i == 0) continue;
        EXPECT_FALSE(field_.inside(area, End::left, own(i))) << i;
      }
      break;
    case Restart::FREE_BALL: {
      EXPECT_NEAR((placed_.ball - GetParam().spot).norm(), 0.0, 1e-12);
      for (const End end : both_ends) {
        const Vec2 contender = placed_.robots[index_of(end)][1].position;
        EXPECT_NEAR(contender.x(), placed_.ball.x() - attack_sign(end) * field_.free_ball_offset,
                    1e-9);
        EXPECT_NEAR(contender.y(), placed_.ball.y(), 1e-9);
        for (int i = 2; i < n; ++i) {
          const Vec2 p = placed_.robots[index_of(end)][i].position;
          const Vec2 sign{GetParam().spot.x() > 0.0 ? 1.0 : -1.0,
                          GetParam().spot.y() > 0.0 ? 1.0 : -1.0};
          const bool in_quarter = p.x() * sign.x() > -half && p.y() * sign.y() > -half;
          EXPECT_FALSE(in_quarter) << i;
        }
      }
      break;
    }
  }
}

}  // namespace
}  // namespace mirocup::referee
