// SPDX-License-Identifier: MIT
//
// The progress of a team from entry to entry, in friendlies against house teams and in drills.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <functional>
#include <string>

namespace mirocup::league {

// Returns the entries that played, the latest first, from FriendlyDesk::list(): [{"entry", "legs",
// "rating", "low", "high", "against": {NAME: {"legs", "goals", "against"}}, "fouls",
// "slowest_tick_ms", "drills", "former"}]. `rating` is the strength of an entry (table/rating.hpp)
// above the mean of the house teams. It is fitted to all friendlies of the list against house
// teams, so each new friendly changes it. `low` and `high` are the ends of its 95 % interval.
// `fouls` is the mean number of fouls in a leg, and `slowest_tick_ms` the longest tick of all legs;
// either is null if no record of the entry's legs is left. `drills` is the result of `drills_of`
// for an entry (FriendlyDesk::drills_of()), or null. `former` compares the entry with the entry
// before it, by their legs against each other: {"entry", "legs", "difference", "low", "high",
// "verdict"}, the difference in strength with its 95 % interval, and "better", "worse" or "not told
// apart"; null if the two have not met.
nlohmann::ordered_json progress_of(
    const nlohmann::ordered_json& friendlies,
    const std::function<nlohmann::ordered_json(int entry)>& drills_of);

// Returns a sentence that compares the latest entry with the entry before it; "" if fewer than two
// entries played. Goals are compared over the house teams that both entries have met, marks over
// the drills that both entries have tried in the same version.
std::string change_in_words(const nlohmann::ordered_json& progress);

}  // namespace mirocup::league
