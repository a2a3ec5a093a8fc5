// SPDX-License-Identifier: MIT
//
// Catches a wrong limit of robots or time, a crowd that is called with the ball far away, and a
// robot that was pushed into the area and is counted.
#include "core/referee/laws/crowding.hpp"

#include "core/referee/touches.hpp"
#include "tests/support/law_test.hpp"

#include <gtest/gtest.h>

namespace mirocup::referee {
namespace {

class Crowding : public test_support::LawTest {
 protected:
  // Robots of `team` in the area of the right end, the ball near it.
  TickFacts crowd(End team, int robots, const Vec2& ball = {0.64, 0.1}) {
    TickFacts s = with_ball(ball);
    for (int i = 0; i < robots; ++i) {
      s.robots[index_of(team)][i] = {{pitch_.field.half_length - 0.1, 0.1 * i - 0.15}, Heading{}};
    }
    return s;
  }

  int judge(CrowdingLaw law, const TickFacts& s, std::optional<End> goal_at = std::nullopt) {
    if (goal_at) goal_at = at(*goal_at);
    const auto in_tick = [&](const TickFacts& turned) {
      update_occupancy(pitch_.pitch(), turned, occupancy_);
      return judge_crowding(law, pitch_.pitch(), turned, occupancy_, goal_at, memory_);
    };
    return ticks_until_called(s, in_tick);
  }

  CrowdingMemory memory_;
};
INSTANTIATE_TEST_SUITE_P(BothEnds, Crowding, testing::ValuesIn(both_ends), test_support::end_name);

TEST_P(Crowding, TwoDefendersCostAPenaltyAfterHalfASecond) {
  EXPECT_EQ(judge(CrowdingLaw::two_defenders, crowd(End::right, 2)), 16) << "15 ticks are 0.495 s";
  expect_call(called_, Verdict::PENALTY_KICK, End::right, End::left);
  EXPECT_EQ(called_->law, Law::two_defenders);
  EXPECT_EQ(called_->robots[index_of(at(End::right))].to_ulong(), 0b011u);
  EXPECT_EQ(judge(CrowdingLaw::two_defenders, crowd(End::right, 1)), 0) << "one may stay";
}

TEST_P(Crowding, TwoAttackersCostAGoalKickAfterAMomentThreeAtOnce) {
  EXPECT_EQ(judge(CrowdingLaw::two_attackers, crowd(End::left, 2)), 11);
  expect_call(called_, Verdict::GOAL_KICK, End::left);
  memory_ = {};
  EXPECT_EQ(judge(CrowdingLaw::two_attackers, crowd(End::left, 3)), 1);
}

TEST_P(Crowding, CountsTheTimeButIsNotCalledWhileTheBallIsFarAway) {
  EXPECT_EQ(judge(CrowdingLaw::two_defenders, crowd(End::right, 2, {0.0, 0.0})), 0);
  EXPECT_EQ(judge(CrowdingLaw::two_defenders, crowd(End::right, 2)), 1);
}

TEST_P(Crowding, AGoalCountsAsABallInTheZoneForAttackersOnly) {
  const Vec2 far{0.0, 0.0};
  EXPECT_EQ(judge(CrowdingLaw::two_attackers, crowd(End::left, 3, far), End::right), 1);
  EXPECT_EQ(judge(CrowdingLaw::two_defenders, crowd(End::right, 3, far), End::right), 0);
}

TEST_P(Crowding, ARobotPushedIntoTheAreaDoesNotCount) {
  TickFacts s = crowd(End::right, 2);
  s.robots[index_of(End::left)][0] = {s.robots[index_of(End::right)][1].position + Vec2{-0.08, 0.0},
                                      Heading{}};
  s.commanded[index_of(End::left)][0] = {0.3, 0.0};
  set_touch(s, {End::left, 0}, {End::right, 1});
  EXPECT_EQ(judge(CrowdingLaw::two_defenders, s), 0);
}

TEST_P(Crowding, FourDefendersCostAPenaltyWhereThereIsAPenaltyArea) {
  EXPECT_EQ(judge(CrowdingLaw::four_defenders, crowd(End::right, 3)), 0) << "the small league";
  pitch_ = test_support::TestPitch(RobotLeague::middle);
  const Vec2 ball{0.80, 0.35};
  memory_ = {};
  EXPECT_EQ(judge(CrowdingLaw::four_defenders, crowd(End::right, 3, ball)), 0);
  EXPECT_EQ(judge(CrowdingLaw::four_defenders, crowd(End::right, 4, ball)), 16);
  EXPECT_EQ(called_->law, Law::four_defenders);
}

TEST_P(Crowding, FourAttackersAreAllowedUnlessTheRulesLimitThem) {
  pitch_ = test_support::TestPitch(RobotLeague::middle);
  const TickFacts s = crowd(End::left, 4, {0.80, 0.35});
  EXPECT_EQ(judge(CrowdingLaw::four_attackers, s), 0) << "pa_att_max is 0";
  pitch_.rules.pa_att_max = 3;
  EXPECT_EQ(judge(CrowdingLaw::four_attackers, s), 11);
  expect_call(called_, Verdict::GOAL_KICK, End::left);
}

}  // namespace
}  // namespace mirocup::referee
