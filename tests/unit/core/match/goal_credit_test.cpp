// SPDX-License-Identifier: MIT
//
// Catches a parry that is called an own goal, a deflection that is not, an assist across an
// opponent's touch, and a restart that is named although play went on.
#include "core/match/goal_credit.hpp"

#include "core/field/field.hpp"
#include "core/match/gain.hpp"

#include <gtest/gtest.h>

namespace mirocup::match {
namespace {

constexpr Touch striker{Team::blue, 1};
constexpr Touch passer{Team::blue, 2};
constexpr Touch keeper{Team::yellow, 0};

const simulator::BallState on_target{{0.5, 0.0}, {1.0, 0.0}};
const simulator::BallState wide{{0.5, 0.0}, {1.0, 0.9}};

// Blue attacks the right goal.
class GoalCredits : public testing::Test {
 protected:
  GoalCredit credit() const { return credit_of(goal, contacts, field, simulator::Parameters{}); }

  field::Field field = field::make_field(RobotLeague::small);
  BallContacts contacts;
  Goal goal{.scoring = Team::blue,
            .end = End::right,
            .restart = referee::Restart::KICK_OFF,
            .taker = Team::yellow,
            .control_period = 0.033};
};

TEST_F(GoalCredits, AParryThatDoesNotKeepTheBallOutLeavesTheGoalToTheShooter) {
  contacts.add(10, striker, {});
  contacts.add(20, keeper, on_target);
  EXPECT_EQ(credit().scorer, striker);
  EXPECT_FALSE(credit().own_goal);
}

TEST_F(GoalCredits, ADefenderWhoPutsInABallThatWouldHaveMissedScoresAnOwnGoal) {
  contacts.add(10, striker, {});
  contacts.add(20, keeper, wide);
  EXPECT_EQ(credit().scorer, keeper);
  EXPECT_TRUE(credit().own_goal);
  EXPECT_FALSE(credit().assist);
}

// The state before the whole contact counts, not the one before its last tick.
TEST_F(GoalCredits, AContactOfSeveralTicksIsOne) {
  contacts.add(10, striker, {});
  contacts.add(20, keeper, on_target);
  contacts.add(21, keeper, wide);
  contacts.add(22, keeper, wide);
  EXPECT_EQ(contacts.all().size(), 2U);
  EXPECT_EQ(credit().scorer, striker);
}

TEST_F(GoalCredits, ABallThatBothTeamsHeldIsTheAttackers) {
  for (std::uint32_t tick = 10; tick <= 20; ++tick) contacts.add(tick, striker, {});
  for (std::uint32_t tick = 15; tick <= 25; ++tick) contacts.add(tick, keeper, wide);
  EXPECT_EQ(credit().scorer, striker);
}

TEST_F(GoalCredits, WithoutAnAttackersTouchItIsAnOwnGoalOrNobodys) {
  EXPECT_FALSE(credit().scorer);
  EXPECT_FALSE(credit().own_goal);
  contacts.add(20, keeper, on_target);
  EXPECT_EQ(credit().scorer, keeper);
  EXPECT_TRUE(credit().own_goal);
}

TEST_F(GoalCredits, AnAssistIsATeamMatesTouchWithNoOpponentsBetween) {
  contacts.add(10, passer, {});
  contacts.add(20, striker, {});
  EXPECT_EQ(credit().assist, passer);
  contacts.forget();
  contacts.add(10, passer, {});
  contacts.add(15, keeper, wide);
  contacts.add(20, striker, {});
  EXPECT_FALSE(credit().assist);
}

TEST_F(GoalCredits, TheRestartIsTheKindUntilAnOpponentTouchesTheBall) {
  goal.restart = referee::Restart::PENALTY_KICK;
  goal.taker = Team::blue;
  contacts.add(10, striker, {});
  EXPECT_EQ(credit().kind, GoalKind::penalty);
  goal.taker = Team::yellow;
  EXPECT_EQ(credit().kind, GoalKind::open_play);
}

TEST_F(GoalCredits, ASavedBallThatIsShotInAtOnceIsARebound) {
  goal.taker = Team::blue;
  contacts.add(10, striker, {});
  contacts.add(20, keeper, on_target);
  contacts.add(30, striker, {});
  EXPECT_EQ(credit().kind, GoalKind::rebound);
  contacts.forget();
  contacts.add(10, striker, {});
  contacts.add(20, keeper, wide);
  contacts.add(30, striker, {});
  EXPECT_EQ(credit().kind, GoalKind::open_play) << "it was no save";
  contacts.forget();
  contacts.add(20, keeper, on_target);
  contacts.add(60, striker, {});
  EXPECT_EQ(credit().kind, GoalKind::open_play) << "more than a second later";
}

TEST(Parties, TheTeamOfTheRestartGainsAndTheOtherOffended) {
  referee::Decision penalty;
  penalty.verdict = referee::Verdict::PENALTY_KICK;
  const Parties p = parties_of(penalty, Team::yellow, Team::blue);
  EXPECT_EQ(p.gainer, Team::blue);
  EXPECT_EQ(p.offender, Team::yellow);
  referee::Decision free_ball;
  free_ball.verdict = referee::Verdict::FREE_BALL;
  EXPECT_FALSE(parties_of(free_ball, std::nullopt, Team::blue).gainer) << "a stalemate";
  referee::Decision goal_kick;
  goal_kick.verdict = referee::Verdict::GOAL_KICK;
  EXPECT_FALSE(parties_of(goal_kick, Team::blue, Team::blue).offender) << "the keeper caught it";
}

}  // namespace
}  // namespace mirocup::match
