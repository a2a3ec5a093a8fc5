// SPDX-License-Identifier: MIT
//
// Catches phases in the wrong order, a shoot-out that is counted as goals or ends too early, lots
// that are never drawn, and a count that outlives its restart.
#include "core/referee/referee.hpp"

#include "tests/support/law_test.hpp"

#include <gtest/gtest.h>

namespace mirocup::referee {
namespace {

using namespace test_support;

class ShootOutCourse : public testing::TestWithParam<End> {
 protected:
  ShootOutCourse() : pitch_(test_.pitch()), referee_(pitch_, {.stage = Stage::knockout}) {
    referee_.start_shoot_out(GetParam(), opposite(GetParam()));
    referee_.resume(referee_.opening());
  }

  // Plays one attempt of the team whose turn it is. Returns what follows from it.
  std::optional<Decision> attempt(bool scored) {
    TickFacts s = empty_situation(test_.field, {scored ? 0.80 : 0.4, 0.0});
    s.ball_before = {scored ? 0.76 : 0.4, 0.0};
    if (next_ == End::right) s = test_support::half_turned(s);
    std::optional<Decision> over;
    while (!over) over = referee_.judge(s).decision;
    EXPECT_EQ(over->verdict, Verdict::ATTEMPT_END);
    EXPECT_EQ(over->team, next_);
    EXPECT_EQ(over->scored, scored);
    const auto end = referee_.follow_up(*over);
    next_ = over->taker;
    referee_.resume(*over);
    return end;
  }

  TestPitch test_;
  JudgedField pitch_;
  Referee referee_;
  End next_ = GetParam();
};
INSTANTIATE_TEST_SUITE_P(BegunBy, ShootOutCourse, testing::ValuesIn(both_ends), end_name);

TEST_P(ShootOutCourse, EndsAfterThreeAttemptsEachIfOneTeamLeads) {
  for (int round = 0; round < 2; ++round) {
    EXPECT_FALSE(attempt(true));
    EXPECT_FALSE(attempt(false));
  }
  EXPECT_FALSE(attempt(false));
  const auto end = attempt(false);
  ASSERT_TRUE(end);
  EXPECT_EQ(end->verdict, Verdict::MATCH_END);
  EXPECT_EQ(end->law, Law::shoot_out);
  EXPECT_EQ(end->team, GetParam());
  EXPECT_EQ(referee_.score(), (ByEnd<int>{0, 0})) << "attempts are no goals";
}

TEST_P(ShootOutCourse, GoesOnInPairsUntilOneLeads) {
  for (int i = 0; i < 6; ++i) EXPECT_FALSE(attempt(true));
  EXPECT_FALSE(attempt(false));
  const auto end = attempt(true);
  ASSERT_TRUE(end);
  EXPECT_EQ(end->team, opposite(GetParam()));
}

TEST_P(ShootOutCourse, IsDecidedByLotsAtLast) {
  std::optional<Decision> end;
  int attempts = 0;
  while (!end && attempts < 1000) {
    end = attempt(false);
    ++attempts;
  }
  ASSERT_TRUE(end);
  EXPECT_EQ(attempts, 2 * test_.rules.shoot_out_most_rounds);
  EXPECT_EQ(end->law, Law::lots);
  EXPECT_EQ(end->team, opposite(GetParam()));
}

TEST(Referee, PublishesTheCountsThatLeadToACall) {
  const TestPitch test;
  const JudgedField pitch = test.pitch();
  Referee referee(pitch, {});
  TickFacts s = empty_situation(test.field, {0.64, 0.1});
  s.robots[index_of(End::right)][0] = {{0.70, 0.0}, Heading{}};
  s.robots[index_of(End::right)][1] = {{0.66, 0.25}, Heading{}};
  for (int i = 0; i < 11; ++i) EXPECT_FALSE(referee.judge(s).decision);
  const TeamCounts right = referee.pending_counts().teams[index_of(End::right)];
  EXPECT_EQ(right.defenders, 2);
  EXPECT_NEAR(right.two_defenders_s, 0.33, 1e-9);
  EXPECT_EQ(right.keeper, 0);
  EXPECT_FALSE(right.advantage_against);
  EXPECT_NEAR(referee.pending_counts().stalemate_s, 0.363, 1e-9);
  for (int i = 0; i < 10; ++i) EXPECT_FALSE(referee.judge(s).decision);
  EXPECT_TRUE(referee.pending_counts().teams[index_of(End::right)].advantage_against);
  EXPECT_GT(referee.pending_counts().advantage_s, 0.0);

  referee.resume({});
  EXPECT_EQ(referee.pending_counts().stalemate_s, 0.0);
  EXPECT_FALSE(referee.pending_counts().teams[index_of(End::right)].advantage_against);
}

TEST(Referee, ChangesScoresAndTimeOutsWithTheEnds) {
  const TestPitch test;
  const JudgedField pitch = test.pitch();
  Referee referee(pitch, {.score = {2, 1}, .time_outs_taken = {1, 0}});
  referee.start_half(Phase::SECOND_HALF);
  EXPECT_EQ(referee.score(), (ByEnd<int>{1, 2}));
  EXPECT_EQ(referee.time_outs_left(End::right), 1);
}

}  // namespace
}  // namespace mirocup::referee
