// SPDX-License-Identifier: MIT
//
// A ladder: it never ends. An entry that is handed in plays a sample of those that are there; the
// table counts what the present entries did.
#pragma once

#include "tournaments/format/schedule.hpp"

#include <cstdint>
#include <vector>

namespace mirocup::league {

// The fixtures of the `event`-th entry (from 1: their round), of `team`, against at most `sample` of
// the others, drawn without favour. The same arguments give the same sample.
std::vector<Fixture> ladder_fixtures(int event, int team, const std::vector<int>& others,
                                     int sample, std::uint64_t league_seed);

}  // namespace mirocup::league
