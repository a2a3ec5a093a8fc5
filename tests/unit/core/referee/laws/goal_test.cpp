// SPDX-License-Identifier: MIT
//
// Catches a goal for the wrong end, one for a ball on the line, one beside the post, one missed
// between samples.
#include "core/referee/laws/goal.hpp"

#include "tests/support/pitch.hpp"

#include <gtest/gtest.h>

namespace mirocup::referee {
namespace {

using namespace test_support;

class Goal : public testing::TestWithParam<End> {
 protected:
  // As written for the team that attacks +x; judged for both.
  std::optional<Decision> judge(const Vec2& from, const Vec2& to,
                                std::optional<RobotId> last_touch = std::nullopt) {
    Situation s = empty_situation(pitch_.field, to);
    s.ball_before = from;
    s.last_touch = last_touch;
    s.begin = 60.0;
    return judge_goal(pitch_.pitch(), GetParam() == End::left ? s : test_support::half_turned(s));
  }

  End attacker() const { return GetParam(); }

  TestPitch pitch_;
};
INSTANTIATE_TEST_SUITE_P(For, Goal, testing::Values(End::left, End::right),
                         [](const auto& end) { return std::string(to_string(end.param)); });

TEST_P(Goal, CountsWhenTheWholeBallIsOver) {
  EXPECT_FALSE(judge({0.76, 0.05}, {0.7713, 0.05}));
  const auto goal = judge({0.76, 0.05}, {0.7714, 0.05}, RobotId{End::left, 1});
  ASSERT_TRUE(goal);
  EXPECT_EQ(goal->verdict, Verdict::GOAL);
  EXPECT_EQ(goal->law, Law::goal);
  EXPECT_EQ(goal->team, attacker());
  EXPECT_EQ(goal->restart, Restart::KICK_OFF);
  EXPECT_EQ(goal->taker, opposite(attacker()));
}

TEST_P(Goal, IsSeenBetweenTwoSamplesAndTimed) {
  const auto goal = judge({0.70, 0.10}, {0.82, 0.12});
  ASSERT_TRUE(goal);
  EXPECT_NEAR(goal->clock, 60.0 + 0.033 * (0.77135 - 0.70) / 0.12, 1e-9);
}

TEST_P(Goal, IsNotBesideThePost) {
  EXPECT_FALSE(judge({0.76, 0.20}, {0.78, 0.20}));
  EXPECT_FALSE(judge({0.70, 0.30}, {0.80, 0.25}));
  EXPECT_TRUE(judge({0.76, 0.199}, {0.78, 0.199}));
}

// Catches a ball that lies in the goal and is never called, since a rebound from a post or a camera
// with gaps makes its straight path cross the line beside the post.
TEST_P(Goal, CountsWhereverTheStraightPathCrosses) {
  const auto goal = judge({0.70, 0.30}, {0.80, 0.19});
  ASSERT_TRUE(goal);
  EXPECT_EQ(goal->team, attacker());
}

TEST_P(Goal, IsCalledAnOwnGoalByTheLastTouch) {
  const auto goal = judge({0.76, 0.0}, {0.78, 0.0}, RobotId{End::right, 0});
  ASSERT_TRUE(goal);
  EXPECT_EQ(goal->law, Law::own_goal);
  EXPECT_EQ(goal->team, attacker());
}

TEST_P(Goal, IsNotABallThatStaysInTheGoal) {
  EXPECT_FALSE(judge({0.79, 0.0}, {0.80, 0.0}));
}

}  // namespace
}  // namespace mirocup::referee
