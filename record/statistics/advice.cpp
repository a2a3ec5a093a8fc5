// SPDX-License-Identifier: MIT
#include "record/statistics/advice.hpp"

#include "record/statistics/report.hpp"

#include <algorithm>

namespace mirocup::statistics {

namespace {

constexpr std::size_t most = 3;        // drills for a team
constexpr int enough_shots = 5;        // below, a share of shots says nothing
constexpr int enough_duels = 10;       // likewise
constexpr double low_share = 0.4;      // of possession, duels and territory
constexpr double good_accuracy = 0.6;  // shots on goal in all shots
constexpr double good_scoring = 0.4;   // goals in shots on goal

// The drills for goals that fell against a team, by their origin.
struct OriginDrill {
  GoalOrigin origin;
  const char* drill;
  const char* words;
};
constexpr OriginDrill origin_drills[] = {
    {GoalOrigin::own_goal, "clear-past-mates", "were own goals"},
    {GoalOrigin::penalty, "save-penalty", "came from penalty kicks"},
    {GoalOrigin::kick_off, "cover-the-goal", "came from kick-offs"},
    {GoalOrigin::free_kick, "cover-the-goal", "came from free kicks"},
    {GoalOrigin::goal_kick, "take-goal-kick", "came from goal kicks"},
    {GoalOrigin::free_ball, "win-free-ball", "came from free balls"},
    {GoalOrigin::rebound, "save-and-clear", "came from rebounds"},
};

// The same for the ball that was lost before a goal in open play.
const char* drill_for(const Loss& loss) {
  if (loss.kind == LossKind::interception) return "pass-to-a-mate";
  if (loss.kind == LossKind::save) return "counter-attack";
  return loss.third == Third::own ? "save-and-clear" : "win-the-ball";
}

std::string of(int part, int all) {
  return std::to_string(part) + " of " + std::to_string(all);
}

// Adds the goals in open play by how the ball was lost before.
void add_losses(const std::vector<LegReport>& legs, const TeamTotals& team,
                std::vector<Advice>& all) {
  const int against = team.against.all_goals();
  for (const Third third : {Third::own, Third::middle, Third::opponent}) {
    for (const LossKind kind : {LossKind::interception, LossKind::save, LossKind::tackle}) {
      int goals = 0;
      for (const LegReport& leg : legs) {
        for (const Goal& goal : leg.statistics.goals) {
          if (counted_name(leg, opponent_of(goal.team)) == team.name && goal.loss &&
              goal.origin == GoalOrigin::open_play && goal.loss->third == third &&
              goal.loss->kind == kind)
            ++goals;
        }
      }
      const Loss loss{.tick = 0, .kind = kind, .place = {}, .third = third};
      all.push_back({drill_for(loss),
                     of(goals, against) + " goals against it fell after it lost the ball in the " +
                         std::string(to_string(third)) + " third by a" +
                         (kind == LossKind::interception ? "n " : " ") +
                         std::string(to_string(kind)),
                     static_cast<double>(goals)});
    }
  }
}

// Adds what the own attack and the fight for the ball lack.
void add_play(const TeamTotals& team, std::vector<Advice>& all) {
  const TeamStatistics& own = team.own;
  const double goals_per_shot = 0.3;  // about what a better shot gives
  const auto missed = [&](int shots) { return goals_per_shot * shots; };
  if (own.shots >= enough_shots && own.shots_on_goal < good_accuracy * own.shots)
    all.push_back({"shoot-open-goal", of(own.shots_on_goal, own.shots) + " shots were on goal",
                   missed(own.shots - own.shots_on_goal)});
  const int kept_out = own.shots_on_goal - own.all_goals();
  if (own.shots_on_goal >= enough_shots && own.all_goals() < good_scoring * own.shots_on_goal)
    all.push_back({"shoot-past-keeper",
                   of(own.all_goals(), own.shots_on_goal) + " shots on goal scored",
                   missed(kept_out)});
  const int decided = own.duels_won + team.against.duels_won;
  if (decided >= enough_duels && own.duels_won < low_share * decided)
    all.push_back({"win-the-ball", "it won " + of(own.duels_won, decided) + " decided duels",
                   0.05 * (decided - own.duels_won)});
  const auto held = share(own.possession_s, team.against.possession_s);
  if (held && *held < low_share)
    all.push_back({"touch-the-ball", "it had the ball in " + percent(held) + " of the play",
                   0.5 * team.legs});
  const int crowd = own.fouls[at(referee::Law::push)];
  if (crowd > team.legs)
    all.push_back({"beside-a-crowd",
                   "it pushed " + std::to_string(crowd) + " times in " + std::to_string(team.legs) +
                       (team.legs == 1 ? " leg" : " legs"),
                   0.1 * crowd});
}

}  // namespace

std::vector<Advice> advice_for(const std::vector<LegReport>& legs, const TeamTotals& team) {
  std::vector<Advice> all;
  const int against = team.against.all_goals();
  for (const auto& [origin, drill, words] : origin_drills) {
    const int goals = team.against.goals[at(origin)];
    all.push_back(
        {drill, of(goals, against) + " goals against it " + words, static_cast<double>(goals)});
  }
  add_losses(legs, team, all);
  add_play(team, all);
  std::erase_if(all, [](const Advice& one) { return one.weight < 0.5; });
  std::stable_sort(all.begin(), all.end(),
                   [](const Advice& a, const Advice& b) { return a.weight > b.weight; });
  std::vector<Advice> kept;  // each drill once, for its greatest reason
  for (const Advice& one : all) {
    const bool is_known = std::any_of(
        kept.begin(), kept.end(), [&one](const Advice& other) { return other.drill == one.drill; });
    if (!is_known && kept.size() < most) kept.push_back(one);
  }
  return kept;
}

}  // namespace mirocup::statistics
