// SPDX-License-Identifier: MIT
#include "record/statistics/statistics_json.hpp"

#include "record/json_reader.hpp"

#include <nlohmann/json.hpp>

#include <charconv>
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

Json or_null(const std::optional<double>& number) {
  return number ? Json(*number) : Json();
}

Json team_json(const TeamStatistics& own, const TeamStatistics& other) {
  return {{"goals", own.all_goals()},
          {"goals_by_kind", names_json<GoalOrigin>(own.goals, true)},
          {"shots", own.shots},
          {"shots_on_goal", own.shots_on_goal},
          {"saves", own.saves},
          {"passes", own.passes},
          {"interceptions", own.interceptions},
          {"losses", own.all_losses()},
          {"losses_by_third", names_json<Third>(own.losses, true)},
          {"duels_won", own.duels_won},
          {"possession_s", own.possession_s},
          {"possession", or_null(share(own.possession_s, other.possession_s))},
          {"opponent_half_s", own.opponent_half_s},
          {"territory", or_null(share(own.opponent_half_s, other.opponent_half_s))},
          {"distance_m", own.distance_m},
          {"fouls", own.all_fouls()},
          {"fouls_by_law", names_json<referee::Law>(own.fouls, false)}};
}

Json robot_json(const std::optional<match::Touch>& robot) {
  if (!robot) return {};
  return {{"team", to_string(robot->team)}, {"robot", robot->robot}};
}

Json loss_json(const std::optional<Loss>& loss) {
  if (!loss) return {};
  return {{"tick", loss->tick},
          {"kind", to_string(loss->kind)},
          {"place", {loss->place.x(), loss->place.y()}},
          {"third", to_string(loss->third)}};
}

Json goal_json(const Goal& goal) {
  return {{"tick", goal.tick},
          {"team", to_string(goal.team)},
          {"kind", to_string(goal.origin)},
          {"scorer", robot_json(goal.scorer)},
          {"restart", to_string(goal.restart)},
          {"restart_law", to_string(goal.restart_law)},
          {"taker", to_string(goal.taker)},
          {"since_restart_s", goal.since_restart},
          {"loss", loss_json(goal.loss)}};
}

Json place_json(const Vec2& place) {
  const auto millimetres = [](double m) { return std::round(m * 1e3) / 1e3; };
  return {millimetres(place.x()), millimetres(place.y())};
}

Json shot_json(const ShotMark& shot) {
  return {{"tick", shot.tick},
          {"team", to_string(shot.team)},
          {"place", place_json(shot.place)},
          {"on_goal", shot.on_goal},
          {"goal", shot.is_goal}};
}

Json pass_json(const PassMark& pass) {
  return {{"tick", pass.tick},
          {"team", to_string(pass.team)},
          {"from", place_json(pass.from)},
          {"to", place_json(pass.to)}};
}

Json foul_json(const Foul& foul) {
  return {{"tick", foul.tick},
          {"team", to_string(foul.team)},
          {"law", to_string(foul.law)},
          {"restart", to_string(foul.restart)}};
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

TeamStatistics read_team(const JsonReader& json) {
  TeamStatistics team;
  team.goals = read_names<GoalOrigin>(json.at("goals_by_kind"));
  team.shots = json.at("shots").integer<int>(0);
  team.shots_on_goal = json.at("shots_on_goal").integer<int>(0);
  team.saves = json.at("saves").integer<int>(0);
  team.passes = json.at("passes").integer<int>(0);
  team.interceptions = json.at("interceptions").integer<int>(0);
  team.losses = read_names<Third>(json.at("losses_by_third"));
  team.duels_won = json.at("duels_won").integer<int>(0);
  team.fouls = read_names<referee::Law>(json.at("fouls_by_law"));
  team.possession_s = json.at("possession_s").number(0.0);
  team.opponent_half_s = json.at("opponent_half_s").number(0.0);
  team.distance_m = json.at("distance_m").number(0.0);
  return team;
}

std::optional<match::Touch> read_robot(const JsonReader& json) {
  if (json.is_null()) return std::nullopt;
  return match::Touch{json.at("team").name<Team>(),
                      json.at("robot").integer<int>(0, max_robots_per_team - 1)};
}

Vec2 read_place(const JsonReader& json) {
  return {json.at(0).number(), json.at(1).number()};
}

std::optional<Loss> read_loss(const JsonReader& json) {
  if (json.is_null()) return std::nullopt;
  return Loss{.tick = json.at("tick").as<std::uint32_t>(),
              .kind = json.at("kind").name<LossKind>(),
              .place = read_place(json.at("place")),
              .third = json.at("third").name<Third>()};
}

Goal read_goal(const JsonReader& json) {
  return {.tick = json.at("tick").as<std::uint32_t>(),
          .team = json.at("team").name<Team>(),
          .origin = json.at("kind").name<GoalOrigin>(),
          .scorer = read_robot(json.at("scorer")),
          .restart = json.at("restart").name<referee::Restart>(),
          .restart_law = json.at("restart_law").name<referee::Law>(),
          .taker = json.at("taker").name<Team>(),
          .since_restart = json.at("since_restart_s").number(0.0),
          .loss = read_loss(json.at("loss"))};
}

ShotMark read_shot(const JsonReader& json) {
  return {.tick = json.at("tick").as<std::uint32_t>(),
          .team = json.at("team").name<Team>(),
          .place = read_place(json.at("place")),
          .on_goal = json.at("on_goal").as<bool>(),
          .is_goal = json.at("goal").as<bool>()};
}

PassMark read_pass(const JsonReader& json) {
  return {.tick = json.at("tick").as<std::uint32_t>(),
          .team = json.at("team").name<Team>(),
          .from = read_place(json.at("from")),
          .to = read_place(json.at("to"))};
}

Foul read_foul(const JsonReader& json) {
  return {.tick = json.at("tick").as<std::uint32_t>(),
          .team = json.at("team").name<Team>(),
          .law = json.at("law").name<referee::Law>(),
          .restart = json.at("restart").name<referee::Restart>()};
}

std::uint64_t read_hash(const JsonReader& json) {
  const std::string digits = json.text();
  std::uint64_t hash = 0;
  const char* const last = digits.data() + digits.size();
  const auto parsed = std::from_chars(digits.data(), last, hash, 16);
  if (parsed.ec != std::errc() || parsed.ptr != last) json.complain("16 digits are expected");
  return hash;
}

LegReport read_leg(const JsonReader& json) {
  json.expect_schema(schema);
  LegReport leg;
  leg.record = json.at("record").text();
  json.read_if_present("leg", leg.leg);
  leg.control_period = json.at("control_period").number(0.0);
  leg.state_hash = read_hash(json.at("state_hash"));
  LegStatistics& s = leg.statistics;
  s.play_s = json.at("play_s").number(0.0);
  s.dead_ball_s = json.at("dead_ball_s").number(0.0);
  s.stoppages = json.at("stoppages").integer<int>(0);
  s.duels = json.at("duels").integer<int>(0);
  for (const Team team : both_teams) {
    const JsonReader own = json.at("teams").at(std::string(to_string(team)));
    leg.names[index_of(team)] = own.at("name").text();
    leg.played[index_of(team)] = json.at("score").at(std::string(to_string(team))).as<int>();
    s.teams[index_of(team)] = read_team(own);
  }
  for (const JsonReader& goal : json.at("goals").elements()) s.goals.push_back(read_goal(goal));
  for (const JsonReader& foul : json.at("fouls").elements()) s.fouls.push_back(read_foul(foul));
  if (!json.has("shots")) return leg;  // a file of an earlier version
  for (const JsonReader& shot : json.at("shots").elements()) s.shots.push_back(read_shot(shot));
  for (const JsonReader& pass : json.at("passes").elements()) s.passes.push_back(read_pass(pass));
  return leg;
}

}  // namespace

Json to_json(const LegStatistics& s) {
  Json goals = Json::array();
  for (const Goal& goal : s.goals) goals.push_back(goal_json(goal));
  Json fouls = Json::array();
  for (const Foul& foul : s.fouls) fouls.push_back(foul_json(foul));
  Json shots = Json::array();
  for (const ShotMark& shot : s.shots) shots.push_back(shot_json(shot));
  Json passes = Json::array();
  for (const PassMark& pass : s.passes) passes.push_back(pass_json(pass));
  return {{"play_s", s.play_s},
          {"dead_ball_s", s.dead_ball_s},
          {"stoppages", s.stoppages},
          {"duels", s.duels},
          {"teams",
           {{"blue", team_json(s.teams[0], s.teams[1])},
            {"yellow", team_json(s.teams[1], s.teams[0])}}},
          {"goals", goals},
          {"fouls", fouls},
          {"shots", shots},
          {"passes", passes}};
}

Json to_json(const LegReport& leg) {
  Json json{{"schema", schema}, {"record", leg.record}};
  if (!leg.leg.empty()) json["leg"] = leg.leg;
  json["state_hash"] = to_hex(leg.state_hash);
  json["control_period"] = leg.control_period;
  json["score"] = {{"blue", leg.played[0]}, {"yellow", leg.played[1]}};
  Json statistics = to_json(leg.statistics);
  for (const Team team : both_teams) {
    Json& own = statistics["teams"][std::string(to_string(team))];
    Json named{{"name", leg.names[index_of(team)]}};
    named.update(own);
    own = named;
  }
  json.update(statistics);
  return json;
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
  for (const TeamTotals& team : totals_of(legs)) teams.push_back(to_json(team));
  return {{"schema", schema}, {"legs", list}, {"teams", teams}};
}

std::string leg_report_text(const LegReport& leg) {
  return record::json_text(to_json(leg), 1) + "\n";
}

Result<LegReport> parse_leg_report(std::string_view text, const std::string& path) {
  return record::read_json<LegReport>(text, path, Errc::damaged, read_leg);
}

}  // namespace mirocup::statistics
