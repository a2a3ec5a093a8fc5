// SPDX-License-Identifier: MIT
//
// Playing parts of a league elsewhere: on more processors, by GNU parallel, on a cluster. A shard
// is a fixture. It only writes records; `league start` finds them, books them and plays what is
// missing, so a shard that is lost is a shard that was not played, and one that runs twice plays
// once.
#pragma once

#include "tournaments/league/league_store.hpp"

#include <string>
#include <vector>

namespace mirocup::league {

// The fixtures that can be played now, in the order of the schedule, without those of teams over
// DDS, which belong to one host.
std::vector<std::string> open_shards(const LeagueState& state);

// Plays the legs of these fixtures that are not decided and have no record, one after the other.
// The value is the number of legs that could not be played. The first interrupt lets the leg that
// is being played come to its end, the second does not (Errc::interrupted).
Result<int> play_shards(system::Files& files, const LeagueStore& store,
                        const std::vector<std::string>& fixtures);

}  // namespace mirocup::league
