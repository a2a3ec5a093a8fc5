// SPDX-License-Identifier: MIT
//
// A ladder, which never ends. Each new entry plays a sample of the present teams. The table counts
// the results of present entries only.
#pragma once

#include "tournaments/format/schedule.hpp"

#include <cstdint>
#include <vector>

namespace mirocup::league {

// Returns the fixtures of the new entry of `team` against at most `sample` other teams, drawn
// uniformly. `event` is the number of entries booked so far, including the new entry; it becomes
// the round of the fixtures. The same arguments give the same sample.
std::vector<Fixture> ladder_fixtures(int event, int team, const std::vector<int>& others,
                                     int sample, std::uint64_t league_seed);

}  // namespace mirocup::league
