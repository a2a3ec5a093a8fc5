// SPDX-License-Identifier: MIT
//
// Plays parts of a league elsewhere: on other machines, by GNU parallel or on a cluster. A shard is
// a fixture. A shard only writes records; `league start` books the records and plays the legs
// without a record. The legs of a lost shard are played later. A shard that runs twice plays its
// legs once.
#pragma once

#include "tournaments/league/league_store.hpp"

#include <string>
#include <vector>

namespace mirocup::league {

// Returns the ids of the fixtures that can be played now, in the order of the schedule. Leaves out
// fixtures of teams that play over DDS or that people start, because only the league's host can
// play such fixtures.
std::vector<std::string> open_shards(const LeagueState& state);

// Plays, one after the other, the legs of these fixtures that are not decided and have no record.
// Returns the number of legs that could not be played. After the first interrupt the present leg is
// still played to its end. The second interrupt stops the leg. After either interrupt the error is
// Errc::interrupted.
Result<int> play_shards(system::Files& files, const LeagueStore& store,
                        const std::vector<std::string>& fixtures);

}  // namespace mirocup::league
