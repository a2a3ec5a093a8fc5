// SPDX-License-Identifier: MIT
//
// Plays parts of a league in other processes, started by GNU parallel or a cluster. A shard is a
// fixture. It only writes records; `league start` finds and books them and plays the missing legs.
// So a lost shard is merely a shard that was not played, and a shard that runs twice plays its legs
// once.
#pragma once

#include "tournaments/league/league_store.hpp"

#include <string>
#include <vector>

namespace mirocup::league {

// Returns the ids of the fixtures that can be played now, in the order of the schedule. Fixtures of
// teams over DDS are left out, because they need the network of one host.
std::vector<std::string> open_shards(const LeagueState& state);

// Plays the legs of these fixtures that are not decided and have no record, one after the other.
// Returns the number of legs that could not be played. After the first interrupt the leg in
// progress is finished; a second one kills it (Errc::interrupted).
Result<int> play_shards(system::Files& files, const LeagueStore& store,
                        const std::vector<std::string>& fixtures);

}  // namespace mirocup::league
