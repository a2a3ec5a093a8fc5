// SPDX-License-Identifier: MIT
#include "record/statistics/advice.hpp"

#include "record/statistics/report.hpp"
#include "system/printable.hpp"
#include "system/text.hpp"

#include <algorithm>
#include <functional>
#include <set>
#include <tuple>

namespace mirocup::statistics {

namespace {

constexpr std::size_t most = 3;        // drills for a team, and moments of each
constexpr int enough_shots = 5;        // below, a share of shots says nothing
constexpr int enough_duels = 10;       // likewise
constexpr double low_share = 0.4;      // of possession, duels and territory
constexpr double good_accuracy = 0.6;  // shots on goal in all shots
constexpr double good_scoring = 0.4;   // goals in shots on goal

// The drills for goals that fell against a team, by their origin.
constexpr std::tuple<GoalOrigin, const char*, const char*> origin_drills[] = {
    {GoalOrigin::own_goal, "clear-past-mates", "were own goals"},
    {GoalOrigin::penalty, "save-penalty", "came from penalty kicks"},
    {GoalOrigin::kick_off, "cover-the-goal", "came from kick-offs"},
    {GoalOrigin::free_kick, "cover-the-goal", "came from free kicks"},
    {GoalOrigin::goal_kick, "take-goal-kick", "came from goal kicks"},
    {GoalOrigin::free_ball, "win-free-ball", "came from free balls"},
    {GoalOrigin::rebound, "save-and-clear", "came from rebounds"},
};

// The drills for fouls, by their law.
constexpr std::tuple<referee::Law, const char*> foul_drills[] = {
    {referee::Law::kick_off, "take-kick-off"},
    {referee::Law::push, "beside-a-crowd"},
    {referee::Law::attacking_push, "beside-a-crowd"},
    {referee::Law::wall_push, "beside-a-crowd"}};
constexpr double goals_per_foul = 0.2;  // about what a restart gives the opponents
constexpr double goals_per_shot = 0.3;  // about what a better shot gives

// The same for the ball that was lost before a goal in open play.
const char* drill_for(LossKind kind, Third third) {
  if (kind == LossKind::interception) return "pass-to-a-mate";
  if (kind == LossKind::save) return "counter-attack";
  return third == Third::own ? "save-and-clear" : "win-the-ball";
}

std::string of(std::size_t part, int all) {
  return std::to_string(part) + " of " + std::to_string(all);
}

struct Events {
  std::size_t count = 0;
  std::string moments;  // the first ones: "leg.json 12.4 s, 31.0 s"
};

// Finds the events of the team's legs for which `is_meant` is true. It gets the team's colour, too.
template <class Event, class IsMeant>
Events find(const std::vector<LegReport>& legs, const TeamTotals& team,
            std::vector<Event> LegStatistics::*events, const IsMeant& is_meant) {
  Events found;
  for (const LegReport& leg : legs) {
    const Team colour = counted_name(leg, Team::blue) == team.name ? Team::blue : Team::yellow;
    if (counted_name(leg, colour) != team.name) continue;
    std::string record = leg.record.empty() ? "" : system::printable(leg.record) + " ";
    for (const Event& event : leg.statistics.*events) {
      if (!is_meant(event, colour) || found.count++ >= most) continue;
      found.moments += (found.count > 1 ? ", " : "") + record +
                       system::formatted("%.1f s", event.tick * leg.control_period);
      record.clear();
    }
  }
  return found;
}

// Adds the goals in open play by how the ball was lost before.
void add_losses(const std::vector<LegReport>& legs, const TeamTotals& team,
                std::vector<Advice>& all) {
  for (const Third third : {Third::own, Third::middle, Third::opponent}) {
    for (const LossKind kind : {LossKind::interception, LossKind::save, LossKind::tackle}) {
      const auto [goals, moments] =
          find(legs, team, &LegStatistics::goals, [&](const Goal& goal, Team own) {
            return goal.team != own && goal.origin == GoalOrigin::open_play && goal.loss &&
                   goal.loss->third == third && goal.loss->kind == kind;
          });
      all.push_back({drill_for(kind, third),
                     of(goals, team.against.all_goals()) +
                         " goals against it fell after it lost the ball in the " +
                         std::string(to_string(third)) + " third by a" +
                         (kind == LossKind::interception ? "n " : " ") +
                         std::string(to_string(kind)),
                     static_cast<double>(goals), moments});
    }
  }
}

// Adds what the own attack and the fight for the ball lack.
void add_play(const std::vector<LegReport>& legs, const TeamTotals& team,
              std::vector<Advice>& all) {
  const TeamStatistics& own = team.own;
  if (own.shots >= enough_shots && own.shots_on_goal < good_accuracy * own.shots)
    all.push_back({"shoot-open-goal", of(own.shots_on_goal, own.shots) + " shots were on goal",
                   goals_per_shot * (own.shots - own.shots_on_goal),
                   find(legs, team, &LegStatistics::shots, [](const ShotMark& shot, Team colour) {
                     return shot.team == colour && !shot.on_goal;
                   }).moments});
  if (own.shots_on_goal >= enough_shots && own.all_goals() < good_scoring * own.shots_on_goal)
    all.push_back({"shoot-past-keeper",
                   of(own.all_goals(), own.shots_on_goal) + " shots on goal scored",
                   goals_per_shot * (own.shots_on_goal - own.all_goals())});
  const int decided = own.duels_won + team.against.duels_won;
  if (decided >= enough_duels && own.duels_won < low_share * decided)
    all.push_back({"win-the-ball", "it won " + of(own.duels_won, decided) + " decided duels",
                   0.05 * (decided - own.duels_won)});
  const auto held = share(own.possession_s, team.against.possession_s);
  if (held && *held < low_share)
    all.push_back({"touch-the-ball", "it had the ball in " + percent(held) + " of the play",
                   0.5 * team.legs});
}

}  // namespace

std::vector<Advice> advice_for(const std::vector<LegReport>& legs, const TeamTotals& team) {
  std::vector<Advice> all;
  for (const auto& [origin, drill, words] : origin_drills) {
    const auto [goals, moments] =
        find(legs, team, &LegStatistics::goals, [origin = origin](const Goal& goal, Team own) {
          return goal.team != own && goal.origin == origin;
        });
    all.push_back({drill, of(goals, team.against.all_goals()) + " goals against it " + words,
                   static_cast<double>(goals), moments});
  }
  add_losses(legs, team, all);
  for (const auto& [law, drill] : foul_drills) {
    const auto [fouls, moments] = find(
        legs, team, &LegStatistics::fouls,
        [law = law](const Foul& foul, Team own) { return foul.team == own && foul.law == law; });
    if (static_cast<int>(fouls) > team.legs)
      all.push_back({drill,
                     std::to_string(fouls) + " fouls by the law " + std::string(to_string(law)),
                     goals_per_foul * static_cast<double>(fouls), moments});
  }
  add_play(legs, team, all);
  std::erase_if(all, [](const Advice& one) { return one.weight < 0.5; });
  std::ranges::stable_sort(all, std::greater(), &Advice::weight);
  std::set<std::string> known;  // each drill once, for its greatest reason
  std::erase_if(all, [&known](const Advice& one) { return !known.insert(one.drill).second; });
  if (all.size() > most) all.resize(most);
  return all;
}

}  // namespace mirocup::statistics
