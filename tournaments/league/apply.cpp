// SPDX-License-Identifier: MIT
//
// The lines of a journal, one by one: whether each may follow, and what it changes. format.md says
// what is in them.
#include "tournaments/format/swiss.hpp"
#include "tournaments/league/league_state.hpp"
#include "tournaments/league/schedule_growth.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <utility>

namespace mirocup::league {

namespace {

std::string text(const Json& line, const char* key) {
  return line.at(key).get<std::string>();
}

std::string text_or(const Json& line, const char* key, const std::string& fallback) {
  return line.contains(key) ? text(line, key) : fallback;
}

// The fixture and the leg that a line is about.
struct Place {
  int fixture;
  int leg;  // from 0
};

Result<Place> place_of(const LeagueState& state, const Json& line) {
  const std::string id = text(line, "fixture");
  const int leg = line.at("leg").get<int>();
  const auto fixture = state.find_fixture(id);
  if (!fixture) return fail(Errc::input, "there is no fixture " + id);
  const FixtureState& f = state.fixtures[*fixture];
  if (leg < 1 || leg > max_legs || !f.fixture.has_both() || leg > f.needed()) {
    return fail(Errc::input, id + " has no leg " + std::to_string(leg) + " to be played");
  }
  return Place{*fixture, leg - 1};
}

// Whoever won or lost this has gone on to play already.
Result<void> nothing_follows(const LeagueState& state, int index) {
  const Fixture& changed = state.fixtures[index].fixture;
  for (const FixtureState& f : state.fixtures) {
    if (f.fixture.part != Part::knockout || !f.has_begun()) continue;
    for (const TeamSource& source : {f.fixture.home_source, f.fixture.away_source}) {
      const bool follows = source.kind == TeamSource::Kind::place
                               ? changed.part == Part::group && changed.group == source.index + 1
                               : source.kind != TeamSource::Kind::team && source.index == index;
      if (follows) {
        return fail(Errc::input, f.fixture.id() + " has begun with who came out of " +
                                     changed.id() + ": void its legs first");
      }
    }
  }
  return {};
}

Result<void> validate_leg(const LeagueState& state, const Json& line) {
  const auto place = place_of(state, line);
  if (!place) return tl::unexpected(place.error());
  const FixtureState& f = state.fixtures[place->fixture];
  const std::string what = f.fixture.id() + " leg " + std::to_string(place->leg + 1);
  if (f.legs[place->leg].played) return fail(Errc::input, what + " is decided already");
  // A leg booked under a wrong name is damage.
  if (text(line, "home") != state.name(f.fixture.home) ||
      text(line, "away") != state.name(f.fixture.away)) {
    return fail(Errc::input,
                what + " is not between " + text(line, "home") + " and " + text(line, "away"));
  }
  for (const char* numbers : {"score", "penalties"}) {
    for (const char* side : {"home", "away"}) (void)line.at(numbers).at(side).get<int>();
  }
  if (!line.at("winner").is_null()) (void)text(line, "winner");
  (void)text(line, "end");
  (void)text(line, "record");
  (void)text(line, "state_hash");
  if (!line.at("fault").is_null()) {
    for (const char* key : {"team", "code", "text"}) (void)text(line.at("fault"), key);
  }
  return {};
}

Result<void> validate_void(const LeagueState& state, const Json& line) {
  const auto place = place_of(state, line);
  if (!place) return tl::unexpected(place.error());
  (void)text(line, "why");
  const std::string cause = text_or(line, "cause", "host");
  const FixtureState& f = state.fixtures[place->fixture];
  const bool is_decided = f.legs[place->leg].played != nullptr;
  const bool by_person = cause == "ruling";
  if (by_person != is_decided) {
    return fail(Errc::input, f.fixture.id() + " leg " + std::to_string(place->leg + 1) +
                                 (is_decided ? " is decided already" : " is not decided yet"));
  }
  return by_person ? nothing_follows(state, place->fixture) : Result<void>();
}

Result<void> validate_ruling(const LeagueState& state, const Json& line) {
  const auto place = place_of(state, line);
  if (!place) return tl::unexpected(place.error());
  for (const char* side : {"home", "away"}) {
    if (line.at("score").at(side).get<int>() < 0)
      return fail(Errc::input, "a score cannot be negative");
  }
  (void)text(line, "why");
  return nothing_follows(state, place->fixture);
}

Result<int> team_of(const LeagueState& state, const Json& line) {
  const std::string name = text(line, "team");
  const auto team = state.find_team(name);
  if (!team) return fail(Errc::input, "there is no team " + name);
  if (state.teams[*team].status == TeamStatus::withdrawn)
    return fail(Errc::input, name + " has withdrawn");
  return *team;
}

Result<void> validate_team_line(const LeagueState& state, const Json& line,
                                const std::string& kind) {
  const auto team = team_of(state, line);
  if (!team) return tl::unexpected(team.error());
  const TeamState& now = state.teams[*team];
  if (kind == "entry") {
    (void)text(line, "sha256");
    if (line.at("entry").get<int>() <= now.entry)
      return fail(Errc::input, text(line, "team") + " plays with a later entry already");
    return {};
  }
  (void)text(line, "why");
  if (kind == "withdraw") {
    const std::string results = text(line, "results");
    if (results != "keep" && results != "annul")
      return fail(Errc::input, "results are to \"keep\" or to \"annul\"");
    return {};
  }
  if ((kind == "resume") != (now.status == TeamStatus::paused)) {
    return fail(Errc::input,
                text(line, "team") + (kind == "resume" ? " is not paused" : " is paused already"));
  }
  return {};
}

// Why a person decided so, and who.
std::string reason(const Json& line) {
  const std::string by = text_or(line, "by", "");
  return text(line, "why") + (by.empty() ? "" : " (" + by + ")");
}

PlayedLeg played_leg(const LeagueState& state, const Fixture& fixture, const Json& line) {
  PlayedLeg leg;
  leg.result.home = fixture.home;
  leg.result.away = fixture.away;
  leg.result.home_goals = line.at("score").at("home").get<int>();
  leg.result.away_goals = line.at("score").at("away").get<int>();
  leg.result.home_penalties = line.at("penalties").at("home").get<int>();
  leg.result.away_penalties = line.at("penalties").at("away").get<int>();
  for (const int team : {fixture.home, fixture.away}) {
    if (line.at("winner") == state.name(team)) leg.winner = team;
  }
  leg.end = text(line, "end");
  leg.result.both_lose = leg.end == "double_forfeit";
  if (!line.at("fault").is_null()) {
    const Json& fault = line.at("fault");
    leg.fault = text(fault, "team") + ": " + text(fault, "code") + ": " + text(fault, "text");
  }
  leg.record = text(line, "record");
  leg.state_hash = text(line, "state_hash");
  return leg;
}

void apply_leg(LeagueState& state, const Json& line, const Place& place) {
  FixtureState& f = state.fixtures[place.fixture];
  LegState& leg = f.legs[place.leg];
  PlayedLeg played = played_leg(state, f.fixture, line);
  if (leg.void_ruling) played.ruling = "what was played before is void: " + *leg.void_ruling;
  leg.played = std::make_shared<const PlayedLeg>(std::move(played));
  const Json& fault = line.at("fault");
  for (const int team : {f.fixture.home, f.fixture.away}) {
    const bool own = !fault.is_null() &&
                     (fault.at("team") == state.name(team) || line.at("end") == "double_forfeit");
    state.teams[team].strikes = own ? state.teams[team].strikes + 1 : 0;
  }
}

void apply_void(LeagueState& state, const Json& line, const Place& place) {
  LegState& leg = state.fixtures[place.fixture].legs[place.leg];
  const std::string cause = text_or(line, "cause", "host");
  ++leg.voids;
  leg.played = nullptr;
  if (cause == "host") {
    ++leg.host_faults;
    return;
  }
  // The next attempt does not overwrite this one's record, which is evidence.
  ++leg.version;
  leg.awaits_confirmation = cause == "confirm";
  if (cause != "ruling") return;
  leg.host_faults = 0;
  leg.void_ruling = std::make_shared<const std::string>(reason(line));
}

void apply_ruling(LeagueState& state, const Json& line, const Place& place) {
  FixtureState& f = state.fixtures[place.fixture];
  PlayedLeg leg;
  if (f.legs[place.leg].played) leg = *f.legs[place.leg].played;
  leg.result.home = f.fixture.home;
  leg.result.away = f.fixture.away;
  leg.result.home_goals = line.at("score").at("home").get<int>();
  leg.result.away_goals = line.at("score").at("away").get<int>();
  leg.result.both_lose = false;
  const int ahead = leg.result.home_goals - leg.result.away_goals;
  leg.winner = ahead > 0 ? f.fixture.home : ahead < 0 ? f.fixture.away : no_team;
  if (leg.end.empty()) leg.end = "awarded";
  leg.ruling = reason(line);
  f.legs[place.leg].played = std::make_shared<const PlayedLeg>(leg);
}

void apply_team_line(LeagueState& state, const Json& line, const std::string& kind) {
  const int index = *state.find_team(text(line, "team"));
  TeamState& team = state.teams[index];
  if (kind == "entry") {
    team.entry = line.at("entry").get<int>();
    team.sha256 = text(line, "sha256");
    team.strikes = 0;
    ScheduleGrowth(state).entry_booked(index);
    return;
  }
  team.why = text(line, "why");
  team.strikes = 0;
  team.status = kind == "withdraw" ? TeamStatus::withdrawn
                : kind == "pause"  ? TeamStatus::paused
                                   : TeamStatus::playing;
  if (kind == "withdraw") ScheduleGrowth(state).team_left(index, text(line, "results") == "annul");
}

bool is_team_line(const std::string& kind) {
  return kind == "entry" || kind == "withdraw" || kind == "pause" || kind == "resume";
}

}  // namespace

LeagueState new_league(LeagueFile file) {
  LeagueState state;
  state.file = std::move(file);
  const int teams = static_cast<int>(state.file.teams.size());
  state.teams.resize(teams);
  for (int i = 0; i < teams; ++i) state.index_of_team_[state.file.teams[i].name] = i;
  if (!objection(state.file.format, teams).empty()) return state;
  ScheduleGrowth schedule(state);
  schedule.add(first_schedule(state.file.format, teams));
  if (state.file.format.kind == FormatKind::swiss) {
    std::vector<SwissStanding> standings;
    for (int team = 0; team < teams; ++team) standings.push_back({team, 0});
    schedule.add(swiss_round(standings, {}, 1, state.file.format.swiss_rounds(teams)));
  }
  return state;
}

Result<void> validate(const LeagueState& state, const Json& line) {
  try {
    const std::string kind = text(line, "kind");
    if (kind == "start") {
      (void)text(line, "config_sha256");
      return state.is_started ? fail(Errc::input, "the league has started already")
                              : Result<void>();
    }
    if (!state.is_started) return fail(Errc::input, "the league has not started");
    if (kind == "leg") return validate_leg(state, line);
    if (kind == "void") return validate_void(state, line);
    if (kind == "ruling") return validate_ruling(state, line);
    if (is_team_line(kind)) return validate_team_line(state, line, kind);
    return fail(Errc::input, "nobody knows what \"" + kind + "\" is");
  } catch (const Json::exception& e) {
    return fail(Errc::input, e.what());
  }
}

void apply(LeagueState& state, const Json& line) {
  const std::string kind = text(line, "kind");
  if (kind == "start") {
    state.is_started = true;
    state.config_sha256 = text(line, "config_sha256");
    return;
  }
  if (is_team_line(kind)) return apply_team_line(state, line, kind);
  const Place place = *place_of(state, line);
  if (kind == "leg") apply_leg(state, line, place);
  if (kind == "void") apply_void(state, line, place);
  if (kind == "ruling") apply_ruling(state, line, place);
  ScheduleGrowth(state).fixture_changed(place.fixture);
}

Result<LeagueState> league_state(LeagueFile file, const Journal& journal) {
  LeagueState state = new_league(std::move(file));
  for (const Json& line : journal.lines()) {
    if (const auto valid = validate(state, line); !valid) {
      return fail(Errc::damaged, journal.path() + ": line " + line.at("n").dump() +
                                     " does not fit the league: " + valid.error().what);
    }
    league::apply(state, line);
  }
  return state;
}

}  // namespace mirocup::league
