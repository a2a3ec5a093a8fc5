// SPDX-License-Identifier: MIT
//
// The starts of episodes without a kick-off: situations, also those of drills, with numbers that
// each episode draws.
#pragma once

#include "core/base/error.hpp"
#include "core/base/random.hpp"
#include "core/match/start.hpp"
#include "record/json_reader.hpp"

#include <string>
#include <vector>

namespace mirocup::training {

// A situation, "mirocup/situation/1" (docs/situations.md), whose numbers may be ranges.
struct StartRanges {
  std::string name;  // name of the start in messages
  nlohmann::ordered_json situation;
};

// Reads one start or a list of starts: a situation, the name of a drill, or the file of a situation
// or a drill. `folder` is the folder of the calling library; the drills are in share/mirocup/drills
// in this folder or one or two folders above it. Complains about a start if its numbers cannot be
// drawn, if it is for another league or, with `is_even`, if a team leads.
std::vector<StartRanges> read_starts(const record::JsonReader& json, League league, bool is_even,
                                     const std::string& folder);

// Draws one of the starts, and its numbers. Precondition: `starts` is not empty.
Result<match::Start> draw_start(const std::vector<StartRanges>& starts, League league,
                                Random& random);

}  // namespace mirocup::training
