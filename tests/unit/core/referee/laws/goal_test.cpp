// SPDX-License-Identifier: MIT
//
// Catches a goal for the wrong end, one for a ball on the line, one beside the post, one missed
// between samples.
#include "core/referee/laws/goal.hpp"

#include "tests/support/law_test.hpp"

#include <gtest/gtest.h>

namespace mirocup::referee {
namespace {

class Goal : public test_support::LawTest {
 protected:
  std::optional<Decision> judge(const Vec2& from, const Vec2& to,
                                std::optional<RobotId> last_touch = std::nullopt) {
    TickFacts s = with_ball(to);
    s.ball_before = from;
    s.last_touch = last_touch;
    s.begin = 60.0;
    return judge_goal(pitch_.pitch(), seen(s));
  }
};
INSTANTIATE_TEST_SUITE_P(BothEnds, Goal, testing::ValuesIn(both_ends), test_support::end_name);

TEST_P(Goal, CountsWhenTheWholeBallIsOver) {
  EXPECT_FALSE(judge({0.76, 0.05}, {0.7713, 0.05}));
  const auto goal = judge({0.76, 0.05}, {0.7714, 0.05}, RobotId{End::left, 1});
  expect_call(goal, Verdict::GOAL, End::left, End::right);
  EXPECT_EQ(goal->law, Law::goal);
  EXPECT_EQ(goal->restart, Restart::KICK_OFF);
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
  EXPECT_FALSE(judge({0.79, 0.0}, {0.80, 0.0})) << "it stays in the goal";
}

// Catches a ball that lies in the goal and is never called, since a rebound from a post or a camera
// with gaps makes its straight path cross the line beside the post.
TEST_P(Goal, CountsWhereverTheStraightPathCrosses) {
  expect_call(judge({0.70, 0.30}, {0.80, 0.19}), Verdict::GOAL, End::left);
}

TEST_P(Goal, IsCalledAnOwnGoalByTheLastTouch) {
  const auto goal = judge({0.76, 0.0}, {0.78, 0.0}, RobotId{End::right, 0});
  expect_call(goal, Verdict::GOAL, End::left);
  EXPECT_EQ(goal->law, Law::own_goal);
}

}  // namespace
}  // namespace mirocup::referee
