// SPDX-License-Identifier: MIT
//
// One leg of a league as a command line of the match server, the same for processes of this host,
// for GNU parallel and for a cluster. The result of the command is the match record that it writes.
#pragma once

#include "tournaments/league/folder.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace mirocup::league {

// Identifies an attempt of a leg.
struct LegId {
  Fixture fixture;
  int leg = 1;      // from 1
  int version = 1;  // number in the name of its record
  int attempt = 1;  // number in the journal
};

// Returns the legs (from 1) of a fixture that can be played now, in order; none unless both teams
// are known and neither is paused or withdrawn.
std::vector<int> open_legs(const LeagueState& state, const FixtureState& fixture);

// Returns the seed of one leg.
std::uint64_t leg_seed(const LeagueState& state, const LegId& id);

// Returns the program and arguments that play the leg from any working directory. Teams over DDS
// find their leg by `match_id`.
std::vector<std::string> leg_command(const Folder& folder, const LeagueState& state,
                                     const LegId& leg, const std::string& match_id);

// Returns the path of the file that receives the output of the leg's match server.
std::string leg_output(const Folder& folder, const LegId& leg);

}  // namespace mirocup::league
