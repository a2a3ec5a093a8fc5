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
// or a drill. `folder` is the library's folder; drills are searched near this folder. Complains
// about a start of which no draw can be played and, if `is_even`, about a start with a lead.
std::vector<StartRanges> read_starts(const record::JsonReader& json, League league, bool is_even,
                                     const std::string& folder);

// Draws one of the starts, and its numbers. Precondition: `starts` is not empty.
Result<match::Start> draw_start(const std::vector<StartRanges>& starts, League league,
                                Random& random);

}  // namespace mirocup::training
