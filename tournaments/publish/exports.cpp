// SPDX-License-Identifier: MIT
#include "tournaments/publish/exports.hpp"

#include "record/csv_rows.hpp"
#include "record/json_reader.hpp"
#include "tournaments/league/league_state.hpp"
#include "tournaments/publish/decision_view.hpp"
#include "tournaments/publish/replay_pages.hpp"

#include <nlohmann/json.hpp>

#include <cmath>
#include <map>
#include <optional>
#include <utility>

namespace mirocup::league {

namespace {

// The status of a match in brackets-model, which is a number there.
enum Status { locked = 0, waiting = 1, ready = 2, running = 3, completed = 4 };

// Fills the tables. Every row has an id, and the ids of its parents.
class BracketTables {
 public:
  explicit BracketTables(const LeagueState& state) : state_(state) {}

  Json make() {
    for (std::size_t i = 0; i < state_.file.teams.size(); ++i) {
      participants_.push_back(
          {{"id", i}, {"tournament_id", 0}, {"name", state_.file.teams[i].name}});
    }
    for (const FixtureState& f : state_.fixtures) add(f);
    return {{"participant", participants_},
            {"stage", stages_},
            {"group", groups_},
            {"round", rounds_},
            {"match", matches_},
            {"match_game", games_}};
  }

 private:
  std::size_t stage_of(const Fixture& f) {
    const bool is_knockout = f.part == Part::knockout;
    const auto [found, is_new] = stage_ids_.try_emplace(is_knockout, stages_.size());
    if (is_new) {
      const bool is_only = !state_.file.format.has_knockout() || stages_.empty();
      const std::string name = state_.file.title + (is_only       ? ""
                                                    : is_knockout ? ", knockout"
                                                                  : ", groups");
      stages_.push_back({{"id", stages_.size()},
                         {"tournament_id", 0},
                         {"name", name},
                         {"type", is_knockout ? "single_elimination" : "round_robin"},
                         {"number", stages_.size() + 1},
                         {"settings", Json::object()}});
    }
    return found->second;
  }

  // The id of a group, which is a bracket in the knockout; the tie for the third place is a second
  // bracket.
  std::size_t group_of(const Fixture& f, std::size_t stage) {
    int number = f.part == Part::group ? f.group : 1;
    if (f.is_for_third_place()) number = 2;
    const auto [found, is_new] = group_ids_.try_emplace({stage, number}, groups_.size());
    if (is_new)
      groups_.push_back({{"id", groups_.size()}, {"stage_id", stage}, {"number", number}});
    return found->second;
  }

  std::size_t round_of(const Fixture& f, std::size_t stage, std::size_t group) {
    const int number = f.is_for_third_place() ? 1 : f.round;
    const auto [found, is_new] = round_ids_.try_emplace({group, number}, rounds_.size());
    if (is_new) {
      rounds_.push_back(
          {{"id", rounds_.size()}, {"stage_id", stage}, {"group_id", group}, {"number", number}});
    }
    return found->second;
  }

  // Returns one side of a match or a game: null for a bye, a null id for a team not known yet.
  static Json opponent(int team) {
    if (team == no_team) return Json();
    return {{"id", team == unknown_team ? Json() : Json(team)}};
  }

  static Status game_status(const FixtureState& f, const PlayedLeg* played) {
    if (played != nullptr) return completed;
    return f.fixture.has_both() ? ready : locked;
  }

  static Status match_status(const FixtureState& f) {
    if (f.is_decided()) return completed;
    if (!f.fixture.has_both()) return locked;
    return f.decided() > 0 ? running : ready;
  }

  // Returns the number of legs that the team has won.
  static int wins(const FixtureState& f, int team) {
    int count = 0;
    for (int leg = 0; leg < f.needed(); ++leg) {
      if (f.legs[leg].played && f.legs[leg].played->result.difference(team) > 0) ++count;
    }
    return count;
  }

  // Returns one side of the whole fixture. Its score is the sum of goals in a knockout, where that
  // sum decides a tie, and the number of won legs elsewhere.
  Json match_opponent(const FixtureState& f, int team) const {
    Json side = opponent(team);
    if (!f.fixture.has_both()) return side;
    if (f.fixture.part != Part::knockout) {
      side["score"] = wins(f, team);
      return side;
    }
    side["score"] = f.goals(team);
    const TieOutcome o = outcome(state_, f);
    if (o.winner >= 0) side["result"] = o.winner == team ? "win" : "loss";
    return side;
  }

  Json game(const FixtureState& f, int leg, std::size_t stage, std::size_t match) const {
    const PlayedLeg* played = f.legs[leg].played.get();
    Json home = opponent(f.fixture.home);
    Json away = opponent(f.fixture.away);
    if (played != nullptr) {
      home["score"] = played->result.home_goals;
      away["score"] = played->result.away_goals;
    }
    return {{"id", games_.size()},
            {"stage_id", stage},
            {"parent_id", match},
            {"number", leg + 1},
            {"status", game_status(f, played)},
            {"opponent1", home},
            {"opponent2", away}};
  }

  void add(const FixtureState& f) {
    const std::size_t stage = stage_of(f.fixture);
    const std::size_t group = group_of(f.fixture, stage);
    const std::size_t round = round_of(f.fixture, stage, group);
    const std::size_t match = matches_.size();
    for (int leg = 0; leg < f.needed(); ++leg) games_.push_back(game(f, leg, stage, match));
    matches_.push_back({{"id", match},
                        {"stage_id", stage},
                        {"group_id", group},
                        {"round_id", round},
                        {"number", f.fixture.is_for_third_place() ? 1 : f.fixture.number},
                        {"child_count", f.fixture.legs},
                        {"status", match_status(f)},
                        {"opponent1", match_opponent(f, f.fixture.home)},
                        {"opponent2", match_opponent(f, f.fixture.away)}});
  }

  const LeagueState& state_;
  Json participants_ = Json::array();
  Json stages_ = Json::array();
  Json groups_ = Json::array();
  Json rounds_ = Json::array();
  Json matches_ = Json::array();
  Json games_ = Json::array();
  std::map<bool, std::size_t> stage_ids_;
  std::map<std::pair<std::size_t, int>, std::size_t> group_ids_;
  std::map<std::pair<std::size_t, int>, std::size_t> round_ids_;
};

// Returns the fixtures as the tables of brackets-model (npm), which brackets-viewer draws: the keys
// "participant", "stage", "group", "round", "match" and "match_game", each with a list of rows. In
// these tables a fixture is a match, and a leg is a match game.
Json bracket_json(const LeagueState& state) {
  return BracketTables(state).make();
}

using record::csv_of;
using record::or_null;

// Returns how many legs would tell the team of a row from the next one: nothing for the last row,
// and if it takes too many.
std::optional<int> legs_to_next(const Overview& o, std::size_t row) {
  if (row + 1 == o.table.size()) return {};
  return legs_to_tell(o.ratings, o.table[row].team, o.table[row + 1].team);
}

std::string fault_text(const PlayedLeg& leg) {
  return leg.fault ? leg.fault->summary() : "";
}

Json legs_json(const Overview& o) {
  Json legs = Json::array();
  for (const LegView& leg : o.legs) {
    Json json{{"fixture", leg.fixture},
              {"round", leg.round},
              {"leg", leg.leg},
              {"home", o.state.name(leg.home)},
              {"away", o.state.name(leg.away)},
              {"played", leg.played != nullptr}};
    if (leg.played != nullptr) {
      const PlayedLeg& p = *leg.played;
      json["score"] = {{"home", p.result.home_goals}, {"away", p.result.away_goals}};
      json["end"] = to_string(p.end);
      json["fault"] = or_null(fault_text(p));
      json["ruling"] = or_null(p.ruling);
      json["record"] = or_null(p.record);
      json["replay"] = or_null(leg.page());
      json["state_hash"] = or_null(p.state_hash);
    }
    legs.push_back(json);
  }
  return {{"title", o.state.file.title}, {"legs", legs}};
}

Json decision_rows(const LeagueState& state) {
  Json decisions = Json::array();
  for (const DecisionView& d : decision_views(state)) {
    decisions.push_back({{"number", d.number},
                         {"at", or_null(d.at)},
                         {"by", or_null(d.by)},
                         {"kind", d.kind},
                         {"what", d.what},
                         {"why", d.why},
                         {"undone_by", d.undone_by == 0 ? Json() : Json(d.undone_by)}});
  }
  return decisions;
}

Json crosstable_json(const Overview& o) {
  const Meetings met = meetings(o);
  Json teams = Json::array();
  Json rows = Json::array();
  for (std::size_t i = 0; i < met.size(); ++i) {
    teams.push_back(o.state.file.teams[i].name);
    Json row = Json::array();
    for (std::size_t j = 0; j < met.size(); ++j) row.push_back(i == j ? Json() : Json(met[i][j]));
    rows.push_back(row);
  }
  return {{"teams", teams}, {"results", rows}};
}

}  // namespace

std::string decisions_json(const LeagueState& state) {
  return record::json_text(
      Json{{"title", state.file.title}, {"decisions", decision_rows(state)}}, 1);
}

Meetings meetings(const Overview& o) {
  const std::size_t teams = o.state.file.teams.size();
  Meetings met(teams, std::vector<std::vector<std::string>>(teams));
  for (const LegView& leg : o.legs) {
    if (leg.played == nullptr) continue;
    const std::string home = std::to_string(leg.played->result.home_goals);
    const std::string away = std::to_string(leg.played->result.away_goals);
    met[leg.home][leg.away].push_back(home + ":" + away);
    met[leg.away][leg.home].push_back(away + ":" + home);
  }
  return met;
}

Json table_json(const Overview& o) {
  Json rows = Json::array();
  for (std::size_t i = 0; i < o.table.size(); ++i) {
    const TableRow& row = o.table[i];
    const TableRow* next = i + 1 < o.table.size() ? &o.table[i + 1] : nullptr;
    const Strength& strength = o.ratings.strengths[row.team];
    const std::string reason = reason_in_words(row, next);
    const auto legs = legs_to_next(o, i);
    rows.push_back({{"rank", i + 1},
                    {"team", o.state.name(row.team)},
                    {"played", row.played},
                    {"won", row.won},
                    {"drawn", row.drawn},
                    {"lost", row.lost},
                    {"goals_for", row.goals_for},
                    {"goals_against", row.goals_against},
                    {"goal_difference", row.difference()},
                    {"points", row.points},
                    {"penalties", row.penalties},
                    {"separated_by", or_null(row.separated_by)},
                    {"reason", or_null(reason)},
                    {"strength",
                     {{"value", std::lround(strength.value)},
                      {"low", std::lround(strength.low)},
                      {"high", std::lround(strength.high)}}},
                    {"legs_to_tell", legs ? Json(*legs) : Json()}});
  }
  return {{"title", o.state.file.title},
          {"format", to_string(o.state.file.format.kind)},
          {"played", o.state.played()},
          {"legs", o.state.legs()},
          {"table", rows}};
}

FileMakers exports(const Overview& o) {
  const auto lines_of = [](const Json& json) { return record::json_text(json, 1) + "\n"; };
  return {{"table.json", [&o, lines_of] { return lines_of(table_json(o)); }},
          {"crosstable.json", [&o, lines_of] { return lines_of(crosstable_json(o)); }},
          {"bracket.json", [&o, lines_of] { return lines_of(bracket_json(o.state)); }},
          {"legs.json", [&o, lines_of] { return lines_of(legs_json(o)); }},
          {"decisions.json", [&o] { return decisions_json(o.state) + "\n"; }},
          {"table.csv",
           [&o] {
             return csv_of(table_json(o)["table"],
                           {"rank", "team", "played", "won", "drawn", "lost", "goals_for",
                            "goals_against", "goal_difference", "points", "penalties",
                            "separated_by", "strength=strength/value", "strength_low=strength/low",
                            "strength_high=strength/high", "legs_to_tell"});
           }},
          {"legs.csv",
           [&o] {
             return csv_of(legs_json(o)["legs"],
                           {"fixture", "round", "leg", "home", "away", "home_goals=score/home",
                            "away_goals=score/away", "end", "fault", "ruling", "record"});
           }},
          {"decisions.csv", [&o] {
             return csv_of(decision_rows(o.state),
                           {"number", "at", "by", "kind", "what", "why", "undone_by"});
           }}};
}

}  // namespace mirocup::league
