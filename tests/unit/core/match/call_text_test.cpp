// SPDX-License-Identifier: MIT
//
// Catches calls that a spectator reads wrongly: one that names the ends, which change at half-time,
// one that does not say who gained or who offended, and goals without scorer and score.
#include "core/match/call_text.hpp"

#include <gtest/gtest.h>

namespace mirocup::match {
namespace {

const ByTeam<std::string> names{"striker", "chaser"};

LoggedDecision call_of(referee::Verdict verdict, std::string reason) {
  LoggedDecision call;
  call.decision.verdict = verdict;
  call.decision.reason = std::move(reason);
  return call;
}

TEST(CallText, EndsBecomeColours) {
  EXPECT_EQ(in_colours("left robot 1 and right robot 2 met", Team::yellow),
            "yellow robot 1 and blue robot 2 met");
  EXPECT_EQ(in_colours("over at left 1 : 4 right", Team::blue), "over at blue 1 : 4 yellow");
  EXPECT_EQ(in_colours("a leftover", Team::blue), "a leftover");
}

TEST(CallText, SaysWhoGainedAndWhoOffended) {
  LoggedDecision call =
      call_of(referee::Verdict::PENALTY_KICK, "yellow robot 2 pushed blue robot 1 0.11 m");
  call.parties = {.gainer = Team::blue, .offender = Team::yellow};
  EXPECT_EQ(call_text(call, names, {}),
            "Penalty kick for striker – chaser 2 pushed striker 1 0.11 m");
  call.decision.reason = "the ball was in the yellow goal area, uncontested, for 10.0 s";
  EXPECT_EQ(
      call_text(call, names, {}),
      "Penalty kick for striker – the ball was in chaser's goal area, uncontested, for 10.0 s");
  call.decision.reason = "more than 1 robots defend";
  EXPECT_EQ(call_text(call, names, {}),
            "Penalty kick for striker – chaser: more than 1 robots defend");
  EXPECT_EQ(call_text(call, {"chaser", "chaser"}, {}),
            "Penalty kick for chaser (blue) – chaser (yellow): more than 1 robots defend");
}

TEST(CallText, AGoalHasItsScorerAndTheScore) {
  LoggedDecision goal =
      call_of(referee::Verdict::GOAL, "the ball crossed the line of the yellow goal");
  goal.team = goal.parties.gainer = Team::blue;
  goal.credit = GoalCredit{.scorer = Touch{.team = Team::yellow, .robot = 0},
                           .assist = std::nullopt,
                           .own_goal = true,
                           .kind = GoalKind::rebound};
  EXPECT_EQ(
      call_text(goal, names, {2, 1}),
      "Goal for striker, 2 : 1 – own goal of chaser 0 (rebound) – the ball crossed the line of "
      "chaser's goal");
}

}  // namespace
}  // namespace mirocup::match
