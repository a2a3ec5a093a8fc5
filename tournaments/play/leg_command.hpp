// SPDX-License-Identifier: MIT
//
// One leg of a league as a command: the same for the processes of this host, for GNU parallel and
// for a cluster. Its record is its result.
#pragma once

#include "tournaments/league/folder.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace mirocup::league {

// Which attempt of which leg.
struct LegId {
  Fixture fixture;
  int leg = 1;      // from 1
  int version = 1;  // of its record
  int attempt = 1;  // in the journal
};

// The legs of a fixture that can be played now, in order: its teams are known and not kept from
// playing.
std::vector<int> open_legs(const LeagueState& state, const FixtureState& fixture);

// The seed of one leg.
std::uint64_t leg_seed(const LeagueState& state, const LegId& id);

// Run it in any folder; `match_id` is for teams that join over DDS.
std::vector<std::string> leg_command(const Folder& folder, const LeagueState& state,
                                     const LegId& leg, const std::string& match_id);

// What its match server says goes into this file.
std::string leg_output(const Folder& folder, const LegId& leg);

}  // namespace mirocup::league
