// SPDX-License-Identifier: MIT
//
// Plays parts of a league elsewhere: on other machines, by GNU parallel or on a cluster. A shard is
// a fixture. Playing a shard only writes records; `league start` books them and plays the legs
// without a record. A lost shard counts as not played, and a shard that runs twice plays its legs
// once.
#pragma once

#include "tournaments/league/league_store.hpp"

#include <string>
#include <vector>

namespace mirocup::league {

// Returns the ids of the fixtures that can be played now, in the order of the schedule. Leaves out
// fixtures of teams that play over DDS or that people start, because only one host can play them.
std::vector<std::string> open_shards(const LeagueState& state);

// Plays the legs of these fixtures that are not decided and have no record, one after the other.
// Returns the number of legs that could not be played. The first interrupt lets the present leg
// come to its end, the second stops it; then the error is Errc::interrupted.
Result<int> play_shards(system::Files& files, const LeagueStore& store,
                        const std::vector<std::string>& fixtures);

}  // namespace mirocup::league
