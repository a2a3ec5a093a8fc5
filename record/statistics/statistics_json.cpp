// SPDX-License-Identifier: MIT
#include "record/statistics/statistics_json.hpp"

#include "record/json_fields.hpp"
#include "record/leg_fields.hpp"
#include "record/statistics/advice.hpp"

#include <cmath>

namespace mirocup::statistics {

namespace {

using record::JsonReader;

constexpr std::string_view schema = "mirocup/statistics/1";

// The counts that are not 0 by name, or all of them.
template <class E>
Json names_json(const PerName<E>& numbers, bool zeros) {
  Json json = Json::object();
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (zeros || numbers[i] != 0) json[std::string(enum_names<E>[i])] = numbers[i];
  }
  return json;
}

template <class E>
PerName<E> read_names(const JsonReader& json) {
  PerName<E> numbers{};
  for (const auto& [name, number] : json.members()) {
    if (const auto known = from_string<E>(name)) {
      numbers[at(*known)] = number.template integer<int>(0);
    } else {
      number.complain("is not one of " + list_of_names<E>());
    }
  }
  return numbers;
}

template <class E, class Fields>
void list_names(Fields& f, const char* key, PerName<E>& numbers, bool zeros) {
  f.as(
      key, [&] { return names_json<E>(numbers, zeros); },
      [&](const JsonReader& json) { numbers = read_names<E>(json); });
}

// `other` gives the shares that only readers of the file need.
void list_team(auto& f, TeamStatistics& own, const TeamStatistics& other) {
  f.only_written("goals", own.all_goals());
  list_names<GoalOrigin>(f, "goals_by_kind", own.goals, true);
  f("shots", own.shots, 0);
  f("shots_on_goal", own.shots_on_goal, 0);
  f("saves", own.saves, 0);
  f("passes", own.passes, 0);
  f("interceptions", own.interceptions, 0);
  f.only_written("losses", own.all_losses());
  list_names<Third>(f, "losses_by_third", own.losses, true);
  f("duels_won", own.duels_won, 0);
  f("possession_s", own.possession_s, 0.0);
  f.only_written("possession", record::fields_json(share(own.possession_s, other.possession_s)));
  f("opponent_half_s", own.opponent_half_s, 0.0);
  f.only_written("territory",
                 record::fields_json(share(own.opponent_half_s, other.opponent_half_s)));
  f("distance_m", own.distance_m, 0.0);
  f.only_written("fouls", own.all_fouls());
  list_names<referee::Law>(f, "fouls_by_law", own.fouls, false);
}

Json team_json(TeamStatistics own, const TeamStatistics& other) {
  record::FieldWriter fields;
  list_team(fields, own, other);
  return fields.object();
}

void list_in_millimetres(auto& f, const char* key, Vec2& place) {
  place = {std::round(place.x() * 1e3) / 1e3, std::round(place.y() * 1e3) / 1e3};
  f(key, place);
}

}  // namespace

static void list_fields(auto& f, Loss& loss) {
  f("tick", loss.tick);
  f("kind", loss.kind);
  f("place", loss.place);
  f("third", loss.third);
}

static void list_fields(auto& f, Goal& goal) {
  f("tick", goal.tick);
  f("team", goal.team);
  f("kind", goal.origin);
  f("scorer", goal.scorer);
  f("restart", goal.restart);
  f("restart_law", goal.restart_law);
  f("taker", goal.taker);
  f("since_restart_s", goal.since_restart, 0.0);
  f("loss", goal.loss);
}

static void list_fields(auto& f, ShotMark& shot) {
  f("tick", shot.tick);
  f("team", shot.team);
  list_in_millimetres(f, "place", shot.place);
  f("on_goal", shot.on_goal);
  f("goal", shot.is_goal);
}

static void list_fields(auto& f, PassMark& pass) {
  f("tick", pass.tick);
  f("team", pass.team);
  list_in_millimetres(f, "from", pass.from);
  list_in_millimetres(f, "to", pass.to);
}

static void list_fields(auto& f, Foul& foul) {
  f("tick", foul.tick);
  f("team", foul.team);
  f("law", foul.law);
  f("restart", foul.restart);
}

// `names` are those of the teams, if these are listed.
static void list_leg(auto& f, LegStatistics& s, match::ByTeam<std::string>* names) {
  f("play_s", s.play_s, 0.0);
  f("dead_ball_s", s.dead_ball_s, 0.0);
  f("stoppages", s.stoppages, 0);
  f("duels", s.duels, 0);
  f.as(
      "teams",
      [&] {
        Json teams;
        for (const Team team : both_teams) {
          Json& own = teams[std::string(to_string(team))];
          if (names != nullptr) own["name"] = (*names)[index_of(team)];
          own.update(team_json(s.teams[index_of(team)], s.teams[index_of(opponent_of(team))]));
        }
        return teams;
      },
      [&](const JsonReader& teams) {
        for (const Team team : both_teams) {
          record::FieldReader fields(teams.at(std::string(to_string(team))));
          if (names != nullptr) fields("name", (*names)[index_of(team)]);
          list_team(fields, s.teams[index_of(team)], {});
        }
      });
  f("goals", s.goals);
  f("fouls", s.fouls);
  f("shots", s.shots);
  f("passes", s.passes);
}

static void list_fields(auto& f, LegStatistics& s) {
  list_leg(f, s, nullptr);
}

static void list_fields(auto& f, LegReport& leg) {
  f.only_written("schema", schema);
  f("record", leg.record);
  f.if_set("leg", leg.leg);
  record::list_hash(f, "state_hash", leg.state_hash);
  f("control_period", leg.control_period, 0.0);
  f("score", leg.played);
  list_leg(f, leg.statistics, &leg.names);
}

Json to_json(const LegStatistics& s) {
  return record::fields_json(s);
}

Json to_json(const LegReport& leg) {
  return record::fields_json(leg);
}

Json to_json(const TeamTotals& team) {
  return {{"name", team.name},
          {"legs", team.legs},
          {"play_s", team.play_s},
          {"dead_ball_s", team.dead_ball_s},
          {"duels", team.duels},
          {"own", team_json(team.own, team.against)},
          {"against", team_json(team.against, team.own)}};
}

Json report_json(const std::vector<LegReport>& legs) {
  Json list = Json::array();
  for (const LegReport& leg : legs) list.push_back(to_json(leg));
  Json teams = Json::array();
  for (const TeamTotals& team : totals_of(legs)) {
    Json& json = teams.emplace_back(to_json(team));
    json["advice"] = Json::array();
    for (const Advice& one : advice_for(legs, team))
      json["advice"].push_back({{"drill", one.drill}, {"why", one.why}, {"moments", one.moments}});
  }
  return {{"schema", schema}, {"legs", list}, {"teams", teams}};
}

std::string leg_report_text(const LegReport& leg) {
  return record::json_text(to_json(leg), 1) + "\n";
}

Result<LegReport> parse_leg_report(std::string_view text, const std::string& path) {
  return record::read_json<LegReport>(text, path, Errc::damaged, [](const JsonReader& json) {
    json.expect_schema(schema);
    return record::read_fields<LegReport>(json);
  });
}

}  // namespace mirocup::statistics
