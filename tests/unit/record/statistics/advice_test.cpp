// SPDX-License-Identifier: MIT
//
// Catches advice about the other team's goals, a drill that mirocup does not have, a figure that is
// not that of the statistics, and advice for a team that lost nothing.
#include "record/statistics/advice.hpp"

#include "system/locations.hpp"

#include <gtest/gtest.h>

#include <filesystem>

namespace mirocup::statistics {
namespace {

Goal goal_against_blue(GoalOrigin origin, std::optional<Loss> loss = std::nullopt) {
  Goal goal;
  goal.team = Team::yellow;
  goal.origin = origin;
  goal.loss = loss;
  goal.tick = 100;
  return goal;
}

// Blue conceded three own goals and two goals after losses, and shot badly.
LegReport leg() {
  LegReport report;
  report.record = "leg.json";
  report.names = {"mine", "striker"};
  const Loss tackled{.tick = 5, .kind = LossKind::tackle, .place = {}, .third = Third::own};
  for (int i = 0; i < 3; ++i)
    report.statistics.goals.push_back(goal_against_blue(GoalOrigin::own_goal));
  for (int i = 0; i < 2; ++i)
    report.statistics.goals.push_back(goal_against_blue(GoalOrigin::open_play, tackled));
  TeamStatistics& other = report.statistics.teams[1];
  report.statistics.fouls.assign(12, {50, Team::yellow, referee::Law::kick_off});
  other.goals[at(GoalOrigin::own_goal)] = 3;
  other.goals[at(GoalOrigin::open_play)] = 2;
  report.statistics.teams[0].shots = 10;
  report.statistics.teams[0].shots_on_goal = 2;
  return report;
}

TEST(Advice, BelongsToWhatWasLost) {
  std::vector<LegReport> legs{leg()};
  const auto totals = totals_of(legs);
  const auto advice = advice_for(legs, totals[0]);
  ASSERT_EQ(advice.size(), 3u);
  EXPECT_EQ(advice[0].drill, "clear-past-mates");
  EXPECT_EQ(advice[0].why, "3 of 5 goals against it were own goals");
  EXPECT_EQ(advice[0].moments, "leg.json 3.3 s, 3.3 s, 3.3 s");
  EXPECT_EQ(advice[1].drill, "shoot-open-goal");
  EXPECT_EQ(advice[1].why, "2 of 10 shots were on goal");
  EXPECT_EQ(advice[2].drill, "save-and-clear");
  EXPECT_EQ(advice[2].why,
            "2 of 5 goals against it fell after it lost the ball in the own third by a tackle");
  for (const Advice& one : advice)
    EXPECT_TRUE(std::filesystem::exists(system::drill_folder() + "/" + one.drill + ".json"))
        << one.drill;
  EXPECT_EQ(advice_for(legs, totals[1])[0].why, "12 fouls by the law kick_off");

  legs[0].statistics.fouls.clear();
  EXPECT_TRUE(advice_for(legs, totals[1]).empty()) << "striker lost nothing";
}

}  // namespace
}  // namespace mirocup::statistics
