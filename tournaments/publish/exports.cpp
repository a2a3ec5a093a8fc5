// SPDX-License-Identifier: MIT
#include "tournaments/publish/exports.hpp"

#include "record/json_reader.hpp"
#include "system/csv.hpp"
#include "tournaments/publish/bracket_json.hpp"
#include "tournaments/publish/decision_view.hpp"
#include "tournaments/publish/replay_pages.hpp"

#include <nlohmann/json.hpp>

#include <cmath>
#include <optional>

namespace mirocup::league {

namespace {

using system::csv_line;

// Returns how many legs would tell the team of a row from the next one: nothing for the last row,
// and if it takes too many.
std::optional<int> legs_to_next(const Overview& o, std::size_t row) {
  if (row + 1 == o.table.size()) return {};
  return legs_to_tell(o.ratings, o.table[row].team, o.table[row + 1].team);
}

std::string table_csv(const Overview& o) {
  std::string text =
      csv_line({"rank", "team", "played", "won", "drawn", "lost", "goals_for", "goals_against",
                "goal_difference", "points", "penalties", "separated_by", "strength",
                "strength_low", "strength_high", "legs_to_tell"});
  for (std::size_t i = 0; i < o.table.size(); ++i) {
    const TableRow& row = o.table[i];
    const Strength& strength = o.ratings.strengths[row.team];
    const auto legs = legs_to_next(o, i);
    text += csv_line(
        {std::to_string(i + 1), o.state.name(row.team), std::to_string(row.played),
         std::to_string(row.won), std::to_string(row.drawn), std::to_string(row.lost),
         std::to_string(row.goals_for), std::to_string(row.goals_against),
         std::to_string(row.difference()), std::to_string(row.points),
         std::to_string(row.penalties), row.separated_by,
         std::to_string(std::lround(strength.value)), std::to_string(std::lround(strength.low)),
         std::to_string(std::lround(strength.high)), legs ? std::to_string(*legs) : std::string()});
  }
  return text;
}

std::string fault_text(const PlayedLeg& leg) {
  return leg.fault ? leg.fault->summary() : "";
}

std::string legs_csv(const Overview& o) {
  std::string text = csv_line({"fixture", "round", "leg", "home", "away", "home_goals",
                               "away_goals", "end", "fault", "ruling", "record"});
  for (const LegView& leg : o.legs) {
    std::vector<std::string> cells{leg.fixture, leg.round, std::to_string(leg.leg),
                                   o.state.name(leg.home), o.state.name(leg.away)};
    if (leg.played == nullptr) {
      cells.resize(11);
    } else {
      const PlayedLeg& p = *leg.played;
      cells.insert(cells.end(),
                   {std::to_string(p.result.home_goals), std::to_string(p.result.away_goals),
                    std::string(to_string(p.end)), fault_text(p), p.ruling, p.record});
    }
    text += csv_line(cells);
  }
  return text;
}

// Returns null for a text that is not known.
Json or_null(const std::string& text) {
  return text.empty() ? Json() : Json(text);
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

std::string decisions_csv(const LeagueState& state) {
  std::string text = csv_line({"number", "at", "by", "kind", "what", "why", "undone_by"});
  for (const DecisionView& d : decision_views(state)) {
    text += csv_line({std::to_string(d.number), d.at, d.by, std::string(d.kind), d.what, d.why,
                      d.undone_by == 0 ? "" : std::to_string(d.undone_by)});
  }
  return text;
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
  return record::json_text(Json{{"title", state.file.title}, {"decisions", decisions}}, 1);
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
                    {"separated_by", row.separated_by.empty() ? Json() : Json(row.separated_by)},
                    {"reason", reason.empty() ? Json() : Json(reason)},
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
          {"table.csv", [&o] { return table_csv(o); }},
          {"legs.csv", [&o] { return legs_csv(o); }},
          {"decisions.csv", [&o] { return decisions_csv(o.state); }}};
}

}  // namespace mirocup::league
