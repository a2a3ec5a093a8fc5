// SPDX-License-Identifier: MIT
#include "tournaments/publish/leg_view.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <utility>

namespace mirocup::league {

namespace {

// Beyond so many fixtures the intervals of the strengths would take longer than a person waits.
constexpr std::size_t max_resampled_fixtures = 20'000;

int last_knockout_round(const LeagueState& state) {
  int last = 0;
  for (const FixtureState& f : state.fixtures) {
    if (f.fixture.part == Part::knockout) last = std::max(last, f.fixture.round);
  }
  return last;
}

std::string with_sign(int number) {
  return (number > 0 ? "+" : "") + std::to_string(number);
}

std::string to(int a, int b) {
  return ", " + std::to_string(a) + " to " + std::to_string(b);
}

std::string points_per_leg(const TableRow& row) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2f", double(row.points) / std::max(1, row.played));
  return text;
}

using Words = std::pair<std::string_view, std::string_view>;

template <std::size_t n>
std::string look_up(const std::array<Words, n>& words, std::string_view key,
                    std::string_view fallback) {
  const auto found =
      std::find_if(words.begin(), words.end(), [key](const Words& w) { return w.first == key; });
  return std::string(found == words.end() ? fallback : found->second);
}

constexpr std::array<Words, 8> ends{{{"full_time", "full time"},
                                     {"golden_goal", "golden goal"},
                                     {"shoot_out", "shoot-out"},
                                     {"forfeit", "forfeit"},
                                     {"double_forfeit", "both forfeited"},
                                     {"mercy", "ended early, goal difference"},
                                     {"awarded", "awarded without play"},
                                     {"withdrawn", "not played, team withdrawn"}}};

constexpr std::array<Words, 9> faults{
    {{"no_load", "the library could not be loaded"},
     {"bad_abi", "it was built against another version of strategy.h"},
     {"start_timeout", "it took too long to create its team"},
     {"crash", "its process crashed"},
     {"hang", "it did not answer in time"},
     {"budget", "it used up the processor time that a leg has"},
     {"illegal_call", "it asked the system for what a strategy may not have"},
     {"bad_command", "it sent commands that are no numbers or out of range, again and again"},
     {"disconnected", "it left the network during the leg"}}};

}  // namespace

int LegView::goals(int team) const {
  return team == home ? played->result.home_goals : played->result.away_goals;
}

char LegView::letter(int team) const {
  if (played->result.both_lose || goals(team) < goals_against(team)) return 'L';
  return goals(team) == goals_against(team) ? 'D' : 'W';
}

Overview overview(const LeagueState& state) {
  Overview o{state, state.table(), {}, {}};
  std::vector<FixtureResults> results;
  for (const FixtureState& f : state.fixtures) {
    if (!f.fixture.has_both()) continue;
    FixtureResults fixture;
    const std::string round = round_in_words(state, f.fixture);
    for (int i = 0; i < f.needed(); ++i) {
      const PlayedLeg* played = f.legs[i].played.get();
      o.legs.push_back({f.fixture.id(), round, i + 1, f.fixture.home, f.fixture.away, played});
      // What nobody played says nothing about strength.
      if (played != nullptr && !played->record.empty()) fixture.push_back(played->result);
    }
    if (!fixture.empty()) results.push_back(std::move(fixture));
  }
  const RatingOptions options{.resamples = results.size() > max_resampled_fixtures ? 0 : 200,
                              .seed = state.file.seed};
  o.strengths = strengths(static_cast<int>(state.file.teams.size()), results, options);
  return o;
}

std::string round_in_words(const LeagueState& state, const Fixture& fixture) {
  const std::string round = "round " + std::to_string(fixture.round);
  if (fixture.part == Part::table) return "R" + round.substr(1);
  if (fixture.part == Part::group) return "Group " + std::to_string(fixture.group) + ", " + round;
  const int left = last_knockout_round(state) - fixture.round;
  if (fixture.home_source.kind == TeamSource::Kind::loser) return "Third place";
  if (left == 0) return "Final";
  if (left == 1) return "Semi-final";
  if (left == 2) return "Quarter-final";
  return "Knockout, " + round;
}

std::string end_in_words(const LeagueState& state, const PlayedLeg& leg) {
  std::string words = look_up(ends, leg.end, leg.end);
  if (leg.end == "shoot_out" && leg.winner >= 0) words += ", won by " + state.name(leg.winner);
  if (!leg.fault.empty()) words += ": " + leg.fault;
  if (!leg.ruling.empty()) words += "; ruling: " + leg.ruling;
  return words;
}

std::string fault_in_words(const std::string& fault) {
  const std::size_t begin = fault.find(": ");
  if (begin == std::string::npos) return "";
  const std::size_t end = fault.find(": ", begin + 2);
  const std::string code = fault.substr(begin + 2, end - begin - 2);
  const std::string words = look_up(faults, code, code);
  return end == std::string::npos ? words : words + ": " + fault.substr(end + 2);
}

std::string reason_in_words(const TableRow& row, const TableRow* next) {
  const std::string& by = row.separated_by;
  if (by.empty() || next == nullptr) return "";
  if (row.played == 0 && next->played == 0) return "";  // nothing has been decided yet
  if (by == "knockout") return "came further in the knockout";
  if (by == "points") return "points" + to(row.points, next->points);
  if (by == "points per leg")
    return "points per leg, " + points_per_leg(row) + " to " + points_per_leg(*next);
  const auto rule = from_string<TieBreak>(by);
  if (!rule) return by;
  switch (*rule) {
    case TieBreak::goal_difference:
      return "goal difference, " + with_sign(row.difference()) + " to " +
             with_sign(next->difference());
    case TieBreak::goals:
      return "goals" + to(row.goals_for, next->goals_for);
    case TieBreak::head_to_head_points:
      return "points in their own meetings";
    case TieBreak::head_to_head_goal_difference:
      return "goal difference in their own meetings";
    case TieBreak::penalties:
      return "fewer penalty kicks against it" + to(row.penalties, next->penalties);
    case TieBreak::lots:
      return "a lot, drawn with the league's seed";
    case TieBreak::wins:
      return "legs won" + to(row.won, next->won);
    case TieBreak::opponents_points:
      return "its opponents have more points";
  }
  return by;
}

}  // namespace mirocup::league
