// SPDX-License-Identifier: MIT
//
// A ladder: a league that never ends. Each new entry plays a sample of the other teams' entries;
// the table counts only the legs of each team's present entry.
#pragma once

#include "tournaments/format/schedule.hpp"

#include <cstdint>
#include <vector>

namespace mirocup::league {

// Returns the fixtures of entry number `event` of the league (from 1; it is also their round),
// which is an entry of `team`. The opponents are at most `sample` of `others`, drawn uniformly. The
// same arguments give the same fixtures.
std::vector<Fixture> ladder_fixtures(int event, int team, const std::vector<int>& others,
                                     int sample, std::uint64_t league_seed);

}  // namespace mirocup::league
