// SPDX-License-Identifier: MIT
#include "tournaments/league/apply.hpp"

#include "core/base/assert.hpp"
#include "record/json_fields.hpp"
#include "tournaments/format/swiss.hpp"
#include "tournaments/league/decisions.hpp"
#include "tournaments/league/schedule_growth.hpp"

#include <memory>
#include <utility>

namespace mirocup::league {

namespace {

// The position of a leg in the state.
struct LegPosition {
  int fixture;
  int leg;  // from 0
};

// Returns the position of a leg (from 1); an error if the fixture does not need that leg.
Result<LegPosition> find_leg(const LeagueState& state, const std::string& id, int leg) {
  const auto fixture = state.find_fixture(id);
  if (!fixture) return fail(Errc::input, "there is no fixture " + id);
  const FixtureState& f = state.fixtures[*fixture];
  if (leg < 1 || leg > max_legs || !f.fixture.has_both() || leg > f.needed()) {
    return fail(Errc::input, id + " has no leg " + std::to_string(leg) + " to be played");
  }
  return LegPosition{.fixture = *fixture, .leg = leg - 1};
}

// Returns the index of a team; an error if it is unknown or has withdrawn.
Result<int> find_present_team(const LeagueState& state, const std::string& name) {
  const auto team = state.find_team(name);
  if (!team) return fail(Errc::input, "there is no team " + name);
  if (state.teams[*team].status == TeamStatus::withdrawn) {
    return fail(Errc::input, name + " has withdrawn");
  }
  return *team;
}

// Refuses a change of a result if a knockout fixture that depends on it has begun.
Result<void> nothing_follows(const LeagueState& state, int index) {
  const Fixture& changed = state.fixtures[index].fixture;
  for (const FixtureState& f : state.fixtures) {
    if (f.fixture.part != Part::knockout || !f.has_begun()) continue;
    for (const TeamSource& source : {f.fixture.home_source, f.fixture.away_source}) {
      const bool follows = source.kind == TeamSource::Kind::place
                               ? changed.part == Part::group && changed.group == source.index + 1
                               : source.kind != TeamSource::Kind::team && source.index == index;
      if (follows) {
        return fail(Errc::input, f.fixture.id() + " depends on the result of " + changed.id() +
                                     " and has begun: first void the legs that it has played");
      }
    }
  }
  return {};
}

// Decides whether an event may follow in a league that has started.
struct Validator {
  const LeagueState& state;

  Result<void> operator()(const Started&) const {
    return fail(Errc::input, "the league has started already");
  }

  Result<void> operator()(const EntryBooked& e) const {
    MIROCUP_TRY(const auto team, find_present_team(state, e.team));
    if (e.entry == state.teams[team].entry) {
      return fail(Errc::input, e.team + " plays with this entry already");
    }
    return {};
  }

  Result<void> operator()(const TeamJoined& e) const {
    if (!state.file.format.is_open_ended())
      return fail(Errc::input, "no team joins a league of this format after its start");
    if (!is_good_name(e.team)) return fail(Errc::input, "\"" + e.team + "\" is no name of a team");
    if (state.find_team(e.team)) return fail(Errc::input, e.team + " is in the league already");
    if (state.teams.size() >= max_teams)
      return fail(Errc::input, "a league has at most " + std::to_string(max_teams) + " teams");
    return is_open();
  }

  Result<void> operator()(const NightBegan& e) const {
    if (auto open = is_open(); !open) return open;
    if (e.number != static_cast<int>(state.nights.size()) + 1)
      return fail(Errc::input, "night " + std::to_string(e.number) + " does not follow night " +
                                   std::to_string(state.nights.size()));
    if (state.file.format.kind != FormatKind::nightly && !e.entries.empty())
      return fail(Errc::input, "entries of a night are for nightly leagues");
    std::set<std::string> teams;
    for (const EntryBooked& entry : e.entries) {
      if (auto valid = (*this)(entry); !valid) return valid;
      if (!teams.insert(entry.team).second)
        return fail(Errc::input, entry.team + " has two entries in a night");
    }
    return {};
  }

  Result<void> operator()(const Frozen& e) const {
    if (!e.from.empty() && !is_time(e.from)) return fail(Errc::input, e.from + " is no time");
    return is_open();
  }

  Result<void> operator()(const Extended& e) const {
    if (!is_time(e.until)) return fail(Errc::input, e.until + " is no time");
    if (!is_good_name(e.team)) return fail(Errc::input, e.team + " is no name of a team");
    return is_open();
  }

  Result<void> operator()(const Closed&) const { return is_open(); }

  Result<void> operator()(const Released&) const { return {}; }

  Result<void> operator()(const Undone& e) const {
    for (const Decision& decision : state.decisions) {
      if (decision.line != e.line) continue;
      if (std::holds_alternative<Undone>(decision.event))
        return fail(Errc::input, "an undoing cannot be undone: decide anew");
      if (!decision.undone_by ||
          !std::holds_alternative<Undone>(state.decisions[*decision.undone_by].event))
        return {};
      return fail(Errc::input, "that decision is undone already");
    }
    return fail(Errc::input, "there is no decision in line " + std::to_string(e.line));
  }

  Result<void> is_open() const {
    if (!state.is_closed) return {};
    return fail(Errc::input,
                "the league is closed: undo that first (league decisions, league undo)");
  }

  Result<void> operator()(const LegPlayed& e) const {
    MIROCUP_TRY(const auto at, find_leg(state, e.fixture, e.leg));
    const FixtureState& f = state.fixtures[at.fixture];
    const std::string name = e.fixture + " leg " + std::to_string(e.leg);
    if (f.legs[at.leg].played) return fail(Errc::input, name + " is decided already");
    // The teams of a line must be those of its fixture; otherwise the journal is damaged.
    if (e.home != state.name(f.fixture.home) || e.away != state.name(f.fixture.away)) {
      return fail(Errc::input, name + " is not a leg of " + e.home + " against " + e.away);
    }
    return {};
  }

  Result<void> operator()(const LegVoided& e) const {
    MIROCUP_TRY(const auto at, find_leg(state, e.fixture, e.leg));
    // Only a ruling can void a decided leg; only an open leg can have a failed attempt.
    const bool is_decided = state.fixtures[at.fixture].legs[at.leg].played != nullptr;
    const bool by_person = e.cause == VoidCause::ruling;
    if (by_person != is_decided) {
      return fail(Errc::input, e.fixture + " leg " + std::to_string(e.leg) +
                                   (is_decided ? " is decided already" : " is not decided yet"));
    }
    if (!by_person) return {};
    return is_open().and_then([&] { return nothing_follows(state, at.fixture); });
  }

  Result<void> operator()(const Ruled& e) const {
    MIROCUP_TRY(const auto at, find_leg(state, e.fixture, e.leg));
    if (e.score.home < 0 || e.score.away < 0) {
      return fail(Errc::input, "a score cannot be negative");
    }
    if (e.score.home > max_count || e.score.away > max_count) {
      return fail(Errc::input, "a score has at most " + std::to_string(max_count) + " goals");
    }
    return is_open().and_then([&] { return nothing_follows(state, at.fixture); });
  }

  Result<void> operator()(const Withdrawn& e) const {
    MIROCUP_TRY_VOID(find_present_team(state, e.team));
    return is_open();
  }

  Result<void> operator()(const Paused& e) const {
    MIROCUP_TRY(const auto team, find_present_team(state, e.team));
    if (state.teams[team].status != TeamStatus::paused) return {};
    return fail(Errc::input, e.team + " is paused already");
  }

  Result<void> operator()(const Resumed& e) const {
    MIROCUP_TRY(const auto team, find_present_team(state, e.team));
    if (state.teams[team].status == TeamStatus::paused) return {};
    return fail(Errc::input, e.team + " is not paused");
  }
};

// Returns a person's reason, with the name of the person if it is known.
std::string signed_reason(const Signature& signature) {
  return signature.why + (signature.by.empty() ? "" : " (" + signature.by + ")");
}

PlayedLeg played_leg(const LeagueState& state, const Fixture& fixture, const LegPlayed& e) {
  PlayedLeg leg;
  leg.result = {.home = fixture.home,
                .away = fixture.away,
                .home_goals = e.score.home,
                .away_goals = e.score.away,
                .both_lose = e.end == LegEnd::double_forfeit,
                .home_penalties = e.penalties.home,
                .away_penalties = e.penalties.away,
                .home_entry = state.teams[fixture.home].entry,
                .away_entry = state.teams[fixture.away].entry};
  for (const int team : {fixture.home, fixture.away}) {
    if (e.winner == state.name(team)) leg.winner = team;
  }
  leg.end = e.end;
  leg.fault = e.fault;
  leg.record = e.record;
  leg.state_hash = e.state_hash;
  return leg;
}

// The changes of a valid event.
struct Applier {
  LeagueState& state;

  void operator()(const Started& e) const {
    plan(state);
    state.is_started = true;
    state.config_sha256 = e.config_sha256;
    state.conditions = e.conditions;
    state.program = {.version = e.version, .build = e.build, .behaviour_hash = e.game};
  }

  void operator()(const NightBegan& e) const {
    for (const EntryBooked& entry : e.entries) (*this)(entry);
    state.nights.push_back(e);
    ScheduleGrowth(state).night_began(e.number);
  }

  void operator()(const Frozen& e) const { state.freeze = e.from; }

  void operator()(const Extended& e) const { state.extensions[e.team] = e.until; }

  void operator()(const Closed& e) const {
    state.is_closed = true;
    state.closing_round = e.closing_round;
  }

  void operator()(const Released& e) const { state.release = e; }

  void operator()(const Undone&) const {}

  void operator()(const EntryBooked& e) const {
    const int index = *state.find_team(e.team);
    TeamState& team = state.teams[index];
    team.entry = e.entry;
    team.sha256 = e.sha256;
    team.strikes = 0;
    ScheduleGrowth(state).entry_booked(index);
  }

  void operator()(const TeamJoined& e) const { ScheduleGrowth(state).team_joined(e); }

  void operator()(const LegPlayed& e) const {
    const LegPosition at = *find_leg(state, e.fixture, e.leg);
    FixtureState& f = state.fixtures[at.fixture];
    LegState& leg = f.legs[at.leg];
    PlayedLeg played = played_leg(state, f.fixture, e);
    if (leg.void_ruling) {
      played.ruling = "what was played before is void: " + *leg.void_ruling;
      if (leg.new_seeds > 0) played.ruling += "; played again with another seed";
    }
    leg.played = std::make_shared<const PlayedLeg>(std::move(played));
    for (const int team : {f.fixture.home, f.fixture.away}) {
      const bool is_own_fault =
          e.fault && (e.fault->team == state.name(team) || e.end == LegEnd::double_forfeit);
      state.teams[team].strikes = is_own_fault ? state.teams[team].strikes + 1 : 0;
    }
    ScheduleGrowth(state).fixture_changed(at.fixture);
  }

  void operator()(const LegVoided& e) const {
    const LegPosition at = *find_leg(state, e.fixture, e.leg);
    LegState& leg = state.fixtures[at.fixture].legs[at.leg];
    ++leg.voids;
    leg.played = nullptr;
    const bool is_by_host = e.cause == VoidCause::host;
    if (is_by_host) ++leg.host_faults;
    // The next attempt must not overwrite this one's record, which is evidence.
    if (!is_by_host || e.has_new_seed) ++leg.version;
    if (!is_by_host) leg.awaits_confirmation = e.cause == VoidCause::confirm;
    leg.new_seeds += e.has_new_seed ? 1 : 0;
    if (e.cause == VoidCause::ruling) {
      leg.host_faults = 0;
      leg.void_ruling = std::make_shared<const std::string>(signed_reason(e.signature));
    }
    ScheduleGrowth(state).fixture_changed(at.fixture);
  }

  void operator()(const Ruled& e) const {
    const LegPosition at = *find_leg(state, e.fixture, e.leg);
    FixtureState& f = state.fixtures[at.fixture];
    PlayedLeg leg;
    if (f.legs[at.leg].played) {
      leg = *f.legs[at.leg].played;
    } else {
      leg.end = LegEnd::awarded;
    }
    leg.result.home = f.fixture.home;
    leg.result.away = f.fixture.away;
    leg.result.home_goals = e.score.home;
    leg.result.away_goals = e.score.away;
    leg.result.both_lose = false;
    const int ahead = e.score.home - e.score.away;
    leg.winner = ahead > 0 ? f.fixture.home : ahead < 0 ? f.fixture.away : no_team;
    leg.ruling = signed_reason(e.signature);
    f.legs[at.leg].played = std::make_shared<const PlayedLeg>(std::move(leg));
    ScheduleGrowth(state).fixture_changed(at.fixture);
  }

  void operator()(const Withdrawn& e) const {
    const int team = *state.find_team(e.team);
    set_status(team, TeamStatus::withdrawn, e.signature.why);
    ScheduleGrowth(state).team_left(team, e.results == WithdrawnResults::annul);
  }

  void operator()(const Paused& e) const {
    set_status(*state.find_team(e.team), TeamStatus::paused, e.signature.why);
  }

  void operator()(const Resumed& e) const {
    set_status(*state.find_team(e.team), TeamStatus::playing, e.signature.why);
  }

  void set_status(int index, TeamStatus status, const std::string& why) const {
    TeamState& team = state.teams[index];
    team.status = status;
    team.why = why;
    team.strikes = 0;
  }
};

}  // namespace

LeagueState unplanned_league(LeagueFile file) {
  LeagueState state;
  state.file = std::move(file);
  std::erase_if(state.file.teams, [](const TeamConfig& team) { return team.has_joined; });
  const int teams = static_cast<int>(state.file.teams.size());
  state.teams.resize(teams);
  for (int i = 0; i < teams; ++i) state.index_of_team_[state.file.teams[i].name] = i;
  return state;
}

void plan(LeagueState& state) {
  const int teams = static_cast<int>(state.teams.size());
  if (!state.fixtures.empty() || !objection(state.file.format, teams).empty()) return;
  ScheduleGrowth schedule(state);
  schedule.add(first_schedule(state.file.format, teams));
  if (state.file.format.kind == FormatKind::swiss) {
    std::vector<SwissStanding> standings;
    for (int team = 0; team < teams; ++team) standings.push_back({.team = team, .points = 0});
    schedule.add(swiss_round(standings, {}, 1, state.file.format.swiss_rounds(teams)));
  }
}

LeagueState new_league(LeagueFile file) {
  LeagueState state = unplanned_league(std::move(file));
  plan(state);
  return state;
}

Result<void> validate(const LeagueState& state, const Event& event) {
  if (state.is_started) return std::visit(Validator{state}, event);
  if (std::holds_alternative<Started>(event)) return {};
  return fail(Errc::input, "the league has not started");
}

void apply(LeagueState& state, const Event& event, int line) {
  MIROCUP_ASSERT(validate(state, event));
  note_decision(state, event, line);
  std::visit(Applier{state}, event);
}

Result<void> apply_line(LeagueState& state, const Json& line, const std::string& journal_path) {
  const auto event = read_event(line);
  if (!event) return fail(Errc::damaged, journal_path + ": " + event.error().what);
  if (const auto valid = validate(state, *event); !valid) {
    return fail(Errc::damaged, journal_path + ": line " + record::json_text(line["n"]) +
                                   " does not fit the league: " + valid.error().what);
  }
  apply(state, *event, record::value_in(line, "n", 0));
  return {};
}

Result<LeagueState> state_from_journal(LeagueFile file, const Journal& journal) {
  return state_from_lines(std::move(file), journal, journal.lines().size());
}

Result<LeagueState> state_from_lines(LeagueFile file, const Journal& journal, std::size_t count,
                                     int undoing) {
  std::set<int> undone = undone_lines(journal, count);
  undone.insert(undoing);
  LeagueState state = unplanned_league(std::move(file));
  for (std::size_t i = 0; i < count; ++i) {
    const Json& line = journal.lines()[i];
    const int number = static_cast<int>(i) + 1;
    if (undone.contains(number)) {
      const auto event = read_event(line);
      if (!event) return fail(Errc::damaged, journal.path() + ": " + event.error().what);
      if (is_of_person(*event)) {
        note_undone_decision(state, *event, number);
        continue;
      }
    }
    MIROCUP_TRY_VOID(apply_line(state, line, journal.path()));
  }
  return state;
}

std::set<int> undone_lines(const Journal& journal, std::size_t count) {
  std::set<int> undone;
  for (std::size_t i = 0; i < count; ++i) {
    const Json& line = journal.lines()[i];
    if (record::text_in(line, "kind") != Undone::kind) continue;
    const auto event = read_event(line);
    if (const auto* e = event ? std::get_if<Undone>(&*event) : nullptr) undone.insert(e->line);
  }
  return undone;
}

}  // namespace mirocup::league
