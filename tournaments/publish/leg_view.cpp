// SPDX-License-Identifier: MIT
#include "tournaments/publish/leg_view.hpp"

#include "core/base/assert.hpp"
#include "core/match/controller.hpp"
#include "system/text.hpp"
#include "tournaments/publish/site_file.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace mirocup::league {

namespace {

int last_knockout_round(const LeagueState& state) {
  int last = 0;
  for (const FixtureState& f : state.fixtures) {
    if (f.fixture.part == Part::knockout) last = std::max(last, f.fixture.round);
  }
  return last;
}

std::string to(std::int64_t a, std::int64_t b) {
  return ", " + std::to_string(a) + " to " + std::to_string(b);
}

// In the order of LegEnd.
constexpr std::array<std::string_view, 8> end_words{"full time",
                                                    "golden goal",
                                                    "shoot-out",
                                                    "forfeit",
                                                    "both forfeited",
                                                    "ended early, goal difference",
                                                    "awarded without play",
                                                    "not played, team withdrawn"};
static_assert(end_words.size() == enum_names<LegEnd>.size());

// In the order of match::FaultCode.
constexpr std::array<std::string_view, 9> fault_words{
    "the library could not be loaded",
    "it was built against another version of strategy.h",
    "it took too long to create its team",
    "its process crashed",
    "it did not answer in time",
    "it used up the processor time that a leg has",
    "it asked the system for what a strategy may not have",
    "it sent commands that are no numbers or out of range, again and again",
    "it left the network during the leg"};
static_assert(fault_words.size() == enum_names<match::FaultCode>.size());

}  // namespace

int LegView::goals(int team) const {
  MIROCUP_ASSERT(played != nullptr && is_of(team));
  return team == home ? played->result.home_goals : played->result.away_goals;
}

std::string LegView::page(const std::string& root, double at, int digits) const {
  if (!has_replay() || is_pruned) return "";
  const std::string page = root + replay_page_of(played->record);
  constexpr double run_up = 3.0;  // s; what came before the moment is shown, too
  return at < 0.0 ? page : page + system::formatted("#t=%.*f", digits, std::max(0.0, at - run_up));
}

bool LegView::is_by_lot() const {
  return played != nullptr && played->end == LegEnd::shoot_out && played->winner >= 0 &&
         facts != nullptr && facts->shoot_out && facts->shoot_out->home == facts->shoot_out->away;
}

bool LegView::counts_for(int team) const {
  return played != nullptr && !is_annulled && is_of(team) &&
         (team == home ? played->result.home_entry_still_plays
                       : played->result.away_entry_still_plays);
}

char LegView::letter(int team) const {
  if (played->result.both_lose || goals(team) < goals_against(team)) return 'L';
  return goals(team) == goals_against(team) ? 'D' : 'W';
}

void LegTotals::add(const LegView& leg, int team) {
  ++legs;
  const char letter = leg.letter(team);
  ++(letter == 'W' ? won : letter == 'D' ? drawn : lost);
  goals += leg.goals(team);
  against += leg.goals_against(team);
}

bool is_of(const statistics::LegReport& report, const PlayedLeg& leg) {
  return to_hex(report.state_hash) == leg.state_hash;
}

Overview overview(const LeagueState& state, const KnownLegs& known) {
  Ratings ratings = state.ratings();
  Overview o{state, state.table(ratings), std::move(ratings), {}, {}};
  o.decided_legs.resize(state.file.teams.size());
  for (const FixtureState& f : state.fixtures) {
    if (!f.fixture.has_both()) continue;
    const std::string round = round_in_words(state, f.fixture);
    for (int i = 0; i < f.needed(); ++i) {
      const PlayedLeg* played = f.legs[i].played.get();
      const auto found = played == nullptr ? known.end() : known.find(played->record);
      const KnownLeg* files = found == known.end() ? nullptr : &found->second;
      const bool counts = files != nullptr && files->report && !f.is_annulled &&
                          !files->report->differs && is_of(*files->report, *played);
      o.legs.push_back({.fixture = f.fixture.id(),
                        .round = round,
                        .leg = i + 1,
                        .home = f.fixture.home,
                        .away = f.fixture.away,
                        .played = played,
                        .facts = files != nullptr && files->facts ? &*files->facts : nullptr,
                        .report = counts ? &*files->report : nullptr,
                        .is_annulled = f.is_annulled,
                        .is_pruned = state.pruned_nights.contains(f.fixture.round)});
      if (played != nullptr) {
        for (const int team : {f.fixture.home, f.fixture.away})
          o.decided_legs[team].push_back(o.legs.size() - 1);
      }
    }
  }
  return o;
}

std::string round_in_words(const LeagueState& state, const Fixture& fixture) {
  const std::string round = "round " + std::to_string(fixture.round);
  if (state.file.format.kind == FormatKind::nightly)
    return "Night " + std::to_string(fixture.round);
  if (fixture.part == Part::table) return "R" + round.substr(1);
  if (fixture.part == Part::group) return "Group " + std::to_string(fixture.group) + ", " + round;
  const int left = last_knockout_round(state) - fixture.round;
  if (fixture.is_for_third_place()) return "Third place";
  if (left == 0) return "Final";
  if (left == 1) return "Semi-final";
  if (left == 2) return "Quarter-final";
  return "Knockout, " + round;
}

std::string end_in_words(const LeagueState& state, const LegView& view) {
  const PlayedLeg& leg = *view.played;
  std::string words(end_words[static_cast<std::size_t>(leg.end)]);
  if (leg.end == LegEnd::shoot_out && leg.winner >= 0) {
    words +=
        (view.is_by_lot() ? ", level, won by lot by " : ", won by ") + state.shown_name(leg.winner);
  }
  if (leg.fault) {
    LegFault fault = *leg.fault;
    fault.team = state.shown_name_of(fault.team);
    words += ": " + fault.summary();
  }
  if (!leg.ruling.empty()) words += "; ruling: " + leg.ruling;
  return words;
}

std::string fault_in_words(const LegFault& fault) {
  const auto code = from_string<match::FaultCode>(fault.code);
  const std::string words(code ? fault_words[static_cast<std::size_t>(*code)] : fault.code);
  return words + ": " + fault.text;
}

std::string with_sign(std::int64_t number) {
  return (number > 0 ? "+" : "") + std::to_string(number);
}

std::string points_per_leg(const TableRow& row) {
  return system::formatted("%.2f", double(row.points) / std::max(1, row.played));
}

bool is_by_lot(const Overview& o, const FixtureState& tie) {
  if (tie.fixture.part != Part::knockout || !tie.fixture.has_both() || !tie.is_decided())
    return false;
  const bool is_level = tie.goals(tie.fixture.home) == tie.goals(tie.fixture.away);
  return is_level && std::ranges::all_of(o.legs, [&tie](const LegView& leg) {
           if (leg.fixture != tie.fixture.id() || leg.played == nullptr) return true;
           if (leg.played->end == LegEnd::withdrawn) return false;
           return leg.played->end != LegEnd::shoot_out || leg.played->winner == no_team ||
                  leg.is_by_lot();
         });
}

std::string reason_in_words(const Overview& o, const TableRow& row, const TableRow* next) {
  const std::string words = reason_in_words(o.ratings, row, next);
  const bool by_lot = row.separated_by == "knockout" && next != nullptr &&
                      std::ranges::any_of(o.state.fixtures, [&](const FixtureState& tie) {
                        return std::minmax(tie.fixture.home, tie.fixture.away) ==
                                   std::minmax(row.team, next->team) &&
                               is_by_lot(o, tie);
                      });
  return by_lot ? words + ", by lot" : words;
}

std::string rank_in_words(const TableRow& row) {
  return row.rank > 0 ? std::to_string(row.rank) : "–";
}

std::optional<bool> is_decided(const LeagueState& state, const Ratings& ratings,
                               const TableRow& row, const TableRow* next) {
  if (!state.file.format.is_open_ended() || next == nullptr || next->rank == 0 ||
      row.separated_by == "withdrawn")
    return std::nullopt;
  return are_apart(ratings, row.team, next->team);
}

std::string reason_in_words(const Ratings& ratings, const TableRow& row, const TableRow* next) {
  const std::string& by = row.separated_by;
  if (by.empty() || next == nullptr) return "";
  if (row.played == 0 && next->played == 0) return "";  // nothing has been decided yet
  if (by == "knockout") return "came further in the knockout";
  if (by == "absent") return "the next team has no leg that counts";
  if (by == "withdrawn") return "the next team has withdrawn";
  if (by == "strength")
    return "strength" + to(std::lround(ratings.strengths[row.team].value),
                           std::lround(ratings.strengths[next->team].value));
  if (by == "points") return "points" + to(row.points, next->points);
  if (by == "points per leg")
    return "points per leg, " + points_per_leg(row) + " to " + points_per_leg(*next);
  const auto rule = from_string<TieBreak>(by);
  if (!rule) return by;
  // Of teams with different numbers of legs, or of byes, the means decide.
  switch (*rule) {
    case TieBreak::goal_difference:
      if (row.difference() <= next->difference()) return "goal difference a leg";
      return "goal difference, " + with_sign(row.difference()) + " to " +
             with_sign(next->difference());
    case TieBreak::goals:
      if (row.goals_for <= next->goals_for) return "goals a leg";
      return "goals" + to(row.goals_for, next->goals_for);
    case TieBreak::head_to_head_points:
      return "points in their own meetings";
    case TieBreak::head_to_head_goal_difference:
      return "goal difference in their own meetings";
    case TieBreak::penalties:
      if (row.penalties >= next->penalties) return "fewer penalty kicks a leg against it";
      return "fewer penalty kicks against it" + to(row.penalties, next->penalties);
    case TieBreak::lots:
      return "a lot, drawn with the league's seed";
    case TieBreak::wins:
      if (row.won <= next->won) return "a larger share of legs won";
      return "legs won" + to(row.won, next->won);
    case TieBreak::opponents_points:
      return "its opponents have more points";
  }
  return by;
}

std::string legs_to_tell_in_words(const Overview& o, const TableRow& row, const TableRow* next) {
  if (next == nullptr || next->rank == 0) return "";
  const auto legs = legs_to_tell(o.ratings, row.team, next->team);
  return legs ? std::to_string(*legs) : "—";
}

}  // namespace mirocup::league
