// SPDX-License-Identifier: MIT
//
// Leagues in a line of code, for tests of what happens in them.
#pragma once

#include "core/base/random.hpp"
#include "system/digest.hpp"
#include "tournaments/league/apply.hpp"
#include "tournaments/league/league_store.hpp"

#include <string>
#include <vector>

namespace mirocup::league {

inline LeagueFile league_file_of(const std::vector<std::string>& names, const Format& format = {},
                                 const std::string& source = "house:idle") {
  LeagueFile file;
  file.format = format;
  for (const std::string& name : names) file.teams.push_back({.name = name, .source = source});
  return file;
}

// Teams t0, t1, …
inline LeagueFile numbered_teams(FormatKind kind, int teams) {
  LeagueFile file = league_file_of({}, {.kind = kind});
  file.seed = 7;
  for (int i = 0; i < teams; ++i)
    file.teams.push_back({.name = "t" + std::to_string(i), .source = "house:idle"});
  return file;
}

// Returns the first line of the journal of the league in this folder.
inline Started start_of(system::Files& files, const Folder& folder) {
  const auto config = files.read(folder.config(), {.max_size = system::size_limit::league_file});
  return {.config_sha256 = system::sha256(config.value()), .version = "0"};
}

// Returns the state of a league right after its start, before its entries are booked.
inline LeagueState started_league(const LeagueFile& file) {
  LeagueState state = new_league(file);
  league::apply(state, Started{.config_sha256 = "x", .version = ""});
  return state;
}

// The same with an entry of each team, whose digest is the team's name.
inline LeagueState league_with_entries(const LeagueFile& file) {
  LeagueState state = started_league(file);
  for (const TeamConfig& team : file.teams)
    league::apply(state, EntryBooked{.team = team.name, .entry = 1, .sha256 = team.name});
  return state;
}

// Returns a leg that was played to its end, the home team in blue.
inline LegPlayed played_leg(const LeagueState& state, const Fixture& fixture, int leg,
                            HomeAway score) {
  LegPlayed played;
  played.fixture = fixture.id();
  played.leg = leg;
  played.home = played.blue = state.name(fixture.home);
  played.away = state.name(fixture.away);
  played.score = score;
  played.record = "records/" + fixture.id() + "-" + std::to_string(leg) + "-1.json";
  played.state_hash = "0";
  return played;
}

// The same with a score that depends on the league's seed, the fixture and the leg only.
inline LegPlayed made_up_leg(const LeagueState& state, const Fixture& fixture, int leg) {
  Random random(fixture_seed(state.file.seed, fixture) + static_cast<std::uint64_t>(leg));
  const int home = static_cast<int>(random.below(4));
  return played_leg(state, fixture, leg, {.home = home, .away = static_cast<int>(random.below(4))});
}

}  // namespace mirocup::league
