// SPDX-License-Identifier: MIT
#include "tournaments/run/league_state.hpp"

#include <algorithm>

namespace mirocup::league {

namespace {

PlayedLeg played_leg(const Fixture& fixture, const Json& line) {
  PlayedLeg leg;
  leg.result.home = fixture.home;
  leg.result.away = fixture.away;
  leg.result.home_goals = line.at("score").at("home").get<int>();
  leg.result.away_goals = line.at("score").at("away").get<int>();
  leg.result.home_penalties = line.at("penalties").at("home").get<int>();
  leg.result.away_penalties = line.at("penalties").at("away").get<int>();
  leg.end = line.at("end").get<std::string>();
  leg.result.both_lose = leg.end == "double_forfeit";
  if (!line.at("fault").is_null()) {
    const Json& fault = line.at("fault");
    leg.fault = fault.at("team").get<std::string>() + ": " + fault.at("code").get<std::string>() +
                ": " + fault.at("text").get<std::string>();
  }
  leg.record = line.at("record").get<std::string>();
  leg.state_hash = line.at("state_hash").get<std::string>();
  return leg;
}

// The league's teams must be those of the line: a leg booked under a wrong name is damage.
bool is_of(const LeagueFile& file, const Fixture& fixture, const Json& line) {
  return line.at("home") == file.teams[fixture.home].name &&
         line.at("away") == file.teams[fixture.away].name;
}

// Applies one line; false if it makes no sense.
bool apply(LeagueState& state, const Json& line) {
  const std::string kind = line.at("kind").get<std::string>();
  if (kind == "start") {
    state.is_started = true;
    state.config_sha256 = line.at("config_sha256").get<std::string>();
    return true;
  }
  if (kind != "leg" && kind != "void") return true;
  const std::string id = line.at("fixture").get<std::string>();
  const int leg = line.at("leg").get<int>();
  const auto found = std::find_if(state.fixtures.begin(), state.fixtures.end(),
                                  [&id](const FixtureState& f) { return f.fixture.id() == id; });
  if (found == state.fixtures.end() || leg < 1 || leg > legs_per_fixture) return false;
  if (kind == "void") {
    ++found->voids[leg - 1];
    return true;
  }
  if (found->legs[leg - 1] || !is_of(state.file, found->fixture, line)) return false;
  found->legs[leg - 1] = played_leg(found->fixture, line);
  return true;
}

}  // namespace

int LeagueState::played() const {
  int count = 0;
  for (const FixtureState& f : fixtures) {
    for (const auto& leg : f.legs) count += leg ? 1 : 0;
  }
  return count;
}

std::vector<LegResult> LeagueState::results() const {
  std::vector<LegResult> results;
  for (const FixtureState& f : fixtures) {
    for (const auto& leg : f.legs) {
      if (leg) results.push_back(leg->result);
    }
  }
  return results;
}

std::vector<Row> LeagueState::table() const {
  return make_table(static_cast<int>(file.teams.size()), results(), file.points, file.tie_breaks,
                    file.seed);
}

Result<LeagueState> league_state(LeagueFile file, const Journal& journal) {
  LeagueState state;
  state.file = std::move(file);
  for (const Fixture& fixture : round_robin(static_cast<int>(state.file.teams.size()))) {
    state.fixtures.push_back({fixture, {}, {}});
  }
  for (const Json& line : journal.lines()) {
    bool good = false;
    try {
      good = apply(state, line);
    } catch (const Json::exception&) {
      good = false;
    }
    if (!good) {
      return fail(Errc::damaged,
                  "journal line " + line.at("n").dump() + " does not fit the league");
    }
  }
  return state;
}

Json leg_line(const LeagueFile& file, const Fixture& fixture, int leg, int attempt,
              const Json& record, const std::string& record_path) {
  const bool home_is_blue = blue_team(fixture, leg) == fixture.home;
  const std::string home_colour = home_is_blue ? "blue" : "yellow";
  const std::string away_colour = home_is_blue ? "yellow" : "blue";
  const std::string& home = file.teams[fixture.home].name;
  const std::string& away = file.teams[fixture.away].name;
  const auto team_of = [&](const Json& colour) -> Json {
    if (colour.is_null()) return Json();
    return colour == home_colour ? home : away;
  };
  int home_penalties = 0;
  int away_penalties = 0;
  for (const Json& d : record.at("decisions")) {
    if (d.at("decision") != "PENALTY_KICK" || d.at("team").is_null()) continue;
    ++(d.at("team") == home_colour ? home_penalties : away_penalties);
  }
  const Json& result = record.at("result");
  Json fault = result.at("fault");
  if (!fault.is_null()) fault["team"] = team_of(fault["team"]);
  return {{"fixture", fixture.id()},
          {"leg", leg},
          {"attempt", attempt},
          {"home", home},
          {"away", away},
          {"blue", home_is_blue ? home : away},
          {"score",
           {{"home", result.at("score").at(home_colour)},
            {"away", result.at("score").at(away_colour)}}},
          {"winner", team_of(result.at("winner"))},
          {"end", result.at("end")},
          {"fault", fault},
          {"penalties", {{"home", home_penalties}, {"away", away_penalties}}},
          {"record", record_path},
          {"state_hash", record.at("state_hash")}};
}

int blue_team(const Fixture& fixture, int leg) {
  return leg == 1 ? fixture.home : fixture.away;
}

}  // namespace mirocup::league
