// SPDX-License-Identifier: MIT
#include "tournaments/publish/exports.hpp"

#include "record/csv_rows.hpp"
#include "record/json_reader.hpp"
#include "system/number_of.hpp"
#include "tournaments/league/decisions.hpp"
#include "tournaments/league/league_state.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <tuple>

namespace mirocup::league {

namespace {

// The status of a match in brackets-model, which is a number there.
enum Status { locked = 0, waiting = 1, ready = 2, running = 3, completed = 4 };

// A row of a table; each row has an id, and the ids of its parents.
template <class... Key>
std::size_t id_of(std::map<std::tuple<Key...>, std::size_t>& ids, const std::tuple<Key...>& key,
                  Json& table, const Json& row) {
  const auto [found, is_new] = ids.try_emplace(key, table.size());
  if (is_new) table.emplace_back(Json{{"id", table.size()}}).update(row);
  return found->second;
}

// One side of a match or a game: null for a bye, a null id for a team not known yet.
Json side_of(int team) {
  if (team == no_team) return Json();
  return {{"id", team == unknown_team ? Json() : Json(team)}};
}

// One side of a tie of the knockout. Its score is the sum of goals, which decides the tie.
Json side_of(const LeagueState& state, const FixtureState& f, int team) {
  Json side = side_of(team);
  if (!f.fixture.has_both()) return side;
  side["score"] = f.goals(team);
  if (const int winner = outcome(state, f).winner; winner >= 0)
    side["result"] = winner == team ? "win" : "loss";
  return side;
}

// One side of a leg in a table. Only what counts there has a result.
Json side_of(const LegResult& leg, int team, bool counts) {
  Json side = side_of(team);
  side["score"] = team == leg.home ? leg.home_goals : leg.away_goals;
  const int ahead = leg.difference(team);
  if (counts) side["result"] = leg.both_lose || ahead < 0 ? "loss" : ahead > 0 ? "win" : "draw";
  return side;
}

// Returns the fixtures as the tables of brackets-model (npm), which brackets-viewer draws: the keys
// "participant", "stage", "group", "round", "match" and "match_game", each with a list of rows. In
// the knockout a fixture is a match. Elsewhere each leg and each bye is a match, so that the viewer
// ranks by legs, as the table does. Each leg is a match game. A group is a bracket in the knockout;
// the tie for the third place is a second bracket.
Json bracket_json(const LeagueState& state) {
  Json tables;
  for (const char* name : {"participant", "stage", "group", "round", "match", "match_game"})
    tables[name] = Json::array();
  for (std::size_t i = 0; i < state.file.teams.size(); ++i)
    tables["participant"].push_back(
        {{"id", i}, {"tournament_id", 0}, {"name", state.file.teams[i].name}});
  std::map<std::tuple<bool>, std::size_t> stages;
  std::map<std::tuple<std::size_t, int>, std::size_t> groups, rounds;
  for (const FixtureState& f : state.fixtures) {
    const Fixture& fixture = f.fixture;
    const bool is_knockout = fixture.part == Part::knockout;
    const bool third_place = fixture.is_for_third_place();
    const std::size_t before = tables["stage"].size();
    const bool is_only = !state.file.format.has_knockout() || before == 0;
    const char* part = is_only ? "" : is_knockout ? ", knockout" : ", groups";
    const std::size_t stage = id_of(stages, {is_knockout}, tables["stage"],
                                    {{"tournament_id", 0},
                                     {"name", state.file.title + part},
                                     {"type", is_knockout ? "single_elimination" : "round_robin"},
                                     {"number", before + 1},
                                     {"settings", Json::object()}});
    const int bracket = third_place ? 2 : fixture.part == Part::group ? fixture.group : 1;
    const std::size_t group = id_of(groups, {stage, bracket}, tables["group"],
                                    {{"stage_id", stage}, {"number", bracket}});
    const int number = third_place ? 1 : fixture.round;
    const std::size_t round = id_of(rounds, {group, number}, tables["round"],
                                    {{"stage_id", stage}, {"group_id", group}, {"number", number}});
    const auto add_match = [&](int leg, int games, Status status, const Json& home,
                               const Json& away) {
      const int legs = is_knockout ? 1 : fixture.legs;
      tables["match"].push_back(
          {{"id", tables["match"].size()},
           {"stage_id", stage},
           {"group_id", group},
           {"round_id", round},
           {"number", third_place ? 1 : (fixture.number - 1) * legs + leg + 1},
           {"child_count", games},
           {"status", status},
           {"opponent1", home},
           {"opponent2", away}});
    };
    for (int leg = 0; leg < f.needed(); ++leg) {
      const PlayedLeg* played = f.legs[leg].played.get();
      const LegResult result = played != nullptr ? played->result : LegResult{};
      const Status status = played != nullptr ? completed : fixture.has_both() ? ready : locked;
      Json home = side_of(fixture.home), away = side_of(fixture.away);
      if (played != nullptr) {
        home = side_of(result, fixture.home, !is_knockout && result.home_entry_still_plays);
        away = side_of(result, fixture.away, !is_knockout && result.away_entry_still_plays);
      }
      tables["match_game"].push_back({{"id", tables["match_game"].size()},
                                      {"stage_id", stage},
                                      {"parent_id", tables["match"].size()},
                                      {"number", is_knockout ? leg + 1 : 1},
                                      {"status", status},
                                      {"opponent1", home},
                                      {"opponent2", away}});
      if (!is_knockout) add_match(leg, 0, status, home, away);
    }
    if (is_knockout) {
      add_match(0, fixture.legs,
                f.is_decided()        ? completed
                : !fixture.has_both() ? locked
                : f.decided() > 0     ? running
                                      : ready,
                side_of(state, f, fixture.home), side_of(state, f, fixture.away));
    } else if (f.needed() == 0) {  // a bye, or a fixture of a team that has left
      const bool is_bye = fixture.away == no_team && fixture.part == Part::table && !f.is_annulled;
      Json home = side_of(fixture.home);
      if (is_bye) home["result"] = "win";
      for (int leg = 0; leg < (is_bye ? legs_per_fixture : 1); ++leg)
        add_match(leg, 0, is_bye ? completed : locked, home, side_of(fixture.away));
    }
  }
  return tables;
}

using record::csv_of;
using record::or_null;

std::string table_csv(const Overview& o) {
  std::vector<std::string> columns;
  columns.insert(
      columns.end(),
      {"rank", "team", "played", "won", "drawn", "lost", "goals_for", "goals_against",
       "goal_difference", "points", "penalties", "separated_by", "strength=strength/value",
       "strength_low=strength/low", "strength_high=strength/high", "legs_to_tell"});
  if (o.state.file.format.is_open_ended())
    columns.insert(columns.end(), {"points_per_leg", "decided"});
  return csv_of(table_json(o)["table"], columns);
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
      json["fault"] = p.fault ? Json(p.fault->summary()) : Json();
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
                         {"at", or_null(d.signature.at)},
                         {"by", or_null(d.signature.by)},
                         {"kind", d.kind},
                         {"what", d.what},
                         {"why", d.signature.why},
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
  return record::json_text(Json{{"title", state.file.title}, {"decisions", decision_rows(state)}},
                           1);
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
    const std::string reason = reason_in_words(o.ratings, row, next);
    const auto legs = system::number_of<int>(legs_to_tell_in_words(o, row, next));
    rows.push_back({{"rank", row.rank > 0 ? Json(row.rank) : Json()},
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
    if (row.rank == 0) rows.back()["strength"] = nullptr;
    if (!o.state.file.format.is_open_ended()) continue;
    const auto decided = is_decided(o.state, o.ratings, row, next);
    rows.back()["points_per_leg"] =
        row.rank > 0 ? Json(std::round(1e3 * double(row.points) / row.played) / 1e3) : Json();
    rows.back()["decided"] = decided ? Json(*decided) : Json();
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
          {"table.csv", [&o] { return table_csv(o); }},
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
