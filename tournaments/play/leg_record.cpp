// SPDX-License-Identifier: MIT
#include "tournaments/play/leg_record.hpp"

#include "core/field/team.hpp"
#include "core/match/leg.hpp"
#include "record/json_reader.hpp"
#include "record/match_record.hpp"
#include "record/team_parameters_json.hpp"

namespace mirocup::league {

namespace {

using record::JsonReader;

// The names of a leg's teams by the colours that they played in.
struct Colours {
  std::string blue;
  std::string yellow;

  const std::string& operator[](Team team) const { return team == Team::blue ? blue : yellow; }
};

// Returns the team whose colour the value names; empty for null.
std::optional<std::string> team_named(const JsonReader& colour, const Colours& names) {
  if (colour.is_null()) return std::nullopt;
  return names[colour.name<Team>()];
}

std::optional<LegFault> read_fault(const JsonReader& fault, const Colours& names) {
  if (fault.is_null()) return std::nullopt;
  return LegFault{.team = names[fault.at("team").name<Team>()],
                  .code = fault.at("code").text(),
                  .text = fault.at("text").text()};
}

// Returns the numbers of penalty kicks given against the home team and the away team.
HomeAway count_penalties(const JsonReader& decisions, bool is_home_blue) {
  HomeAway count;
  for (const JsonReader& decision : decisions.elements()) {
    if (decision.at("decision").text() != "PENALTY_KICK") continue;
    const JsonReader team = decision.at("team");
    if (team.is_null()) continue;
    const bool against_home = (team.name<Team>() == Team::blue) == is_home_blue;
    ++(against_home ? count.home : count.away);
  }
  return count;
}

LegPlayed read_record(const LeagueFile& file, const LegId& id, const JsonReader& record,
                      const std::string& record_path) {
  const bool is_home_blue = Fixture::is_home_blue(id.leg);
  const std::string& home = file.teams[id.fixture.home].name;
  const std::string& away = file.teams[id.fixture.away].name;
  const Colours names{.blue = is_home_blue ? home : away, .yellow = is_home_blue ? away : home};
  const JsonReader result = record.at("result");
  const int blue_goals = result.at("score").at("blue").integer(0, max_count);
  const int yellow_goals = result.at("score").at("yellow").integer(0, max_count);
  return {
      .fixture = id.fixture.id(),
      .leg = id.leg,
      .attempt = id.attempt,
      .home = home,
      .away = away,
      .blue = names.blue,
      .score = {.home = is_home_blue ? blue_goals : yellow_goals,
                .away = is_home_blue ? yellow_goals : blue_goals},
      .winner = team_named(result.at("winner"), names),
      .end = result.at("end").name<LegEnd>(),
      .fault = read_fault(result.at("fault"), names),
      .penalties = count_penalties(record.at("decisions"), is_home_blue),
      .record = record_path,
      .state_hash = record.at("state_hash").text(),
  };
}

// True if the record is of the seed and the teams, with the entries that they play with now, and
// its leg was decided.
bool is_of_leg(const LeagueState& state, const LegId& id, const JsonReader& record) {
  if (record.at("seed").integer<std::uint64_t>() != leg_seed(state, id)) return false;
  const auto [blue, yellow] = id.fixture.colours(id.leg);
  for (const Team colour : both_teams) {
    const int team = colour == Team::blue ? blue : yellow;
    const JsonReader seat = record.at("teams").at(std::string(to_string(colour)));
    if (seat.at("name").text() != state.name(team)) return false;
    // A team over the network loads its library itself, so the record has no hash of it.
    if (state.file.teams[team].is_on_network()) continue;
    if (seat.at("sha256").text() != state.teams[team].sha256) return false;
    if (record::read_team_parameters(seat.at("parameters")) != state.file.teams[team].parameters)
      return false;
  }
  return record.at("result").at("end").text() != to_string(match::OutcomeKind::void_);
}

// Returns the setup of a leg that leg_command() plays.
match::Setup setup_of(const LeagueState& state, const LegId& id) {
  match::Setup setup;
  setup.league = state.file.league;
  setup.rules = state.file.rules;
  if (id.leg > id.fixture.legs) setup.stage = referee::Stage::knockout;
  setup.seed = leg_seed(state, id);
  setup.control_period = match::control_period_of(setup.rules.preset);
  match::set_pitch(setup, state.file.pitch.value_or(match::PitchSpec{}));
  setup.conditions = state.conditions;
  return setup;
}

}  // namespace

Result<LegPlayed> leg_played(const LeagueFile& file, const LegId& id, const Json& record,
                             const std::string& record_path) {
  std::optional<record::JsonProblem> problem;
  LegPlayed leg = read_record(file, id, JsonReader(record, "", problem), record_path);
  if (problem) return tl::unexpected(record::error_of(*problem, record_path, Errc::damaged));
  return leg;
}

Result<std::optional<LegPlayed>> find_played_leg(system::Files& files, const Folder& folder,
                                                 const LeagueState& state, const LegId& id) {
  const std::string path = folder.record(id.fixture, id.leg, id.version);
  const auto text = files.read_if_there(path, {.max_size = system::size_limit::record});
  if (text && !*text) return std::nullopt;
  const auto read = [&](const JsonReader& record) -> std::optional<LegPlayed> {
    if (!is_of_leg(state, id, record)) return std::nullopt;
    return read_record(state.file, id, record, Folder::record_name(id.fixture, id.leg, id.version));
  };
  return text
      .and_then([&](const std::optional<std::string>& bytes) {
        return record::read_json<std::optional<LegPlayed>>(*bytes, path, Errc::damaged, read);
      })
      .map_error([](Error error) {
        error.what += "; the leg may have been played: mend the file, or remove it to play again";
        return error;
      });
}

Result<std::string> impossible_key(system::Files& files, const Folder& folder,
                                   const LeagueState& state, const LegId& id) {
  const std::string path = folder.record(id.fixture, id.leg, id.version);
  MIROCUP_TRY(const auto text, files.read(path, {.max_size = system::size_limit::record}));
  MIROCUP_TRY(auto file, record::parse_record(text, path));
  const Json found = record::parse_json(text).value;
  file.record.recording.setup = setup_of(state, id);
  file.record.from.reset();
  const Json possible = record::to_json(file.record);
  for (const char* key : {"league", "rules", "stage", "control_period", "conditions", "pitch",
                          "situation", "from", "result", "decisions"}) {
    const auto value_in = [key](const Json& json) {
      const auto value = json.find(key);
      return value == json.end() ? Json() : *value;
    };
    if (value_in(found) != value_in(possible)) return key;
  }
  return "";
}

}  // namespace mirocup::league
