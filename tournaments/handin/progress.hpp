// SPDX-License-Identifier: MIT
//
// The progress of a team over its entries, from its friendlies against house teams and its drills.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <functional>
#include <string>

namespace mirocup::league {

// Returns the entries that played, the latest first, from FriendlyDesk::list(): [{"entry", "legs",
// "rating", "low", "high", "against": {NAME: {"legs", "goals", "against"}}, "fouls",
// "slowest_tick_ms", "drills"}].
// A rating is the strength of an entry (table/rating.hpp) above the mean of the house teams, fitted
// to all friendlies of the list against them, so it moves with each; `low` and `high` are its
// interval of 95 %. `fouls` is the mean number of a leg, and `slowest_tick_ms` the greatest of all
// legs; either is null if no record tells it any more. `drills` is what `drills_of` returns of an
// entry (FriendlyDesk::drills_of()), or null.
nlohmann::ordered_json progress_of(
    const nlohmann::ordered_json& friendlies,
    const std::function<nlohmann::ordered_json(int entry)>& drills_of);

// Returns what the latest entry does otherwise than the one before it, a sentence; "" if fewer than
// two entries played. Goals are compared over the house teams that both have met, marks over the
// drills that both have tried in the same version.
std::string change_in_words(const nlohmann::ordered_json& progress);

}  // namespace mirocup::league
