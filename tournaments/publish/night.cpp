// SPDX-License-Identifier: MIT
#include "tournaments/publish/night.hpp"

#include "record/json_fields.hpp"
#include "tournaments/league/apply.hpp"

#include <algorithm>
#include <functional>

namespace mirocup::league {

namespace {

constexpr std::size_t most_moments = 3;

// The weights of moments: a leg that was given away by an own fault, an own goal, the goal after
// which a team stayed behind, any other goal against it.
constexpr int fault_weight = 4;
constexpr int own_goal_weight = 3;
constexpr int decisive_weight = 2;
constexpr int goal_weight = 1;

int rank_of(const Overview& o, int team) {
  const auto row = std::ranges::find(o.table, team, &TableRow::team);
  return row == o.table.end() ? 0 : row->rank;
}

// Adds the moments of a leg that were bad for a team.
void add_moments(const Overview& o, const LegView& leg, int team,
                 std::vector<WorstMoment>& moments) {
  const PlayedLeg& played = *leg.played;
  const std::string against = " against " + o.state.shown_name(leg.other(team));
  if (played.fault && played.fault->team == o.state.name(team)) {
    moments.push_back({.what = "leg lost" + against +
                               " by the team's own fault: " + fault_in_words(*played.fault),
                       .leg = &leg,
                       .at = leg.facts != nullptr ? leg.facts->length : -1.0,
                       .weight = fault_weight});
  }
  if (leg.facts == nullptr) return;
  // The last goal by which the team fell behind, if it stayed so.
  int ahead = 0;
  std::size_t decisive = leg.facts->goals.size();
  for (std::size_t i = 0; i < leg.facts->goals.size(); ++i) {
    const int before = ahead;
    ahead += leg.facts->goals[i].is_home == (leg.home == team) ? 1 : -1;
    if (before == 0 && ahead == -1) decisive = i;
    if (ahead >= 0) decisive = leg.facts->goals.size();
  }
  LegTotals so_far;
  for (std::size_t i = 0; i < leg.facts->goals.size(); ++i) {
    const GoalFact& goal = leg.facts->goals[i];
    const bool is_own_side = goal.is_home == (leg.home == team);
    ++(is_own_side ? so_far.goals : so_far.against);
    if (is_own_side) continue;
    const std::string score = so_far.score() + against;
    moments.push_back({.what = goal.is_own_goal ? "own goal, " + score
                               : i == decisive  ? "the goal that decided, " + score
                                                : "goal, " + score,
                       .leg = &leg,
                       .at = goal.at,
                       .when = in_words(goal.when),
                       .weight = goal.is_own_goal ? own_goal_weight
                                 : i == decisive  ? decisive_weight
                                                  : goal_weight});
  }
}

}  // namespace

Result<std::optional<Night>> last_night(const LeagueState& shown, const Journal& journal) {
  if (shown.nights.empty()) return std::optional<Night>();
  Night night;
  night.number = shown.nights.back().number;
  night.at = shown.nights.back().at;
  const std::vector<Json>& lines = journal.lines();
  std::size_t begin = 0;
  for (; begin < lines.size(); ++begin) {
    if (record::text_in(lines[begin], "kind") == NightBegan::kind &&
        record::value_in(lines[begin], "number", 0) == night.number)
      break;
  }
  MIROCUP_TRY(auto before, state_from_lines(shown.file, journal, begin));
  before.shown_names = shown.shown_names;
  night.before = std::move(before);
  for (std::size_t i = begin + 1; i < lines.size(); ++i) {
    if (record::text_in(lines[i], "kind") == NightBegan::kind) break;
    if (record::text_in(lines[i], "kind") != LegPlayed::kind) continue;
    const auto event = read_event(lines[i]);
    if (!event) return fail(Errc::damaged, journal.path() + ": " + event.error().what);
    night.records.insert(std::get<LegPlayed>(*event).record);
  }
  return std::optional(std::move(night));
}

std::vector<TeamDigest> digests(const Night& night, const Overview& now) {
  const Overview before = overview(night.before);
  std::vector<TeamDigest> all;
  for (const TableRow& row : now.table) {
    const int team = row.team;
    TeamDigest digest;
    digest.team = team;
    digest.rank = rank_of(now, team);
    digest.rank_before = rank_of(before, team);
    if (row.rank > 0) digest.strength = now.ratings.strengths[team];
    if (digest.rank_before > 0) digest.strength_before = before.ratings.strengths[team];
    digest.entry = now.state.teams[team].entry;
    // A team that joined in the night is not in the league before.
    const auto known = night.before.find_team(now.state.name(team));
    digest.has_new_entry = digest.entry != (known ? night.before.teams[*known].entry : 0);
    for (const LegView& leg : now.legs) {
      if (!leg.is_of(team) || leg.played == nullptr || !night.records.contains(leg.played->record))
        continue;
      digest.legs.add(leg, team);
      if (leg.letter(team) == 'L') digest.losses.push_back(&leg);
      add_moments(now, leg, team, digest.moments);
    }
    std::ranges::stable_sort(digest.moments, std::greater(), &WorstMoment::weight);
    if (digest.moments.size() > most_moments) digest.moments.resize(most_moments);
    all.push_back(std::move(digest));
  }
  return all;
}

}  // namespace mirocup::league
