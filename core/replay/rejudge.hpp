// SPDX-License-Identifier: MIT
//
// A played leg judged again with other parameters of the laws.
//
// Robots and ball move as they did while a second referee watches. If it decides otherwise than the
// first, the leg would have gone on differently from there; so every difference concerns the leg as
// it was played, not the one that would have been. At each stoppage of the leg the second referee
// starts afresh from the state of the first.
#pragma once

#include "core/replay/recording.hpp"

#include <optional>
#include <vector>

namespace mirocup::replay {

// A tick in which the two referees did not decide the same.
struct Difference {
  std::uint32_t tick = 0;
  std::optional<match::LoggedDecision> given;     // as it was played
  std::optional<match::LoggedDecision> would_be;  // with the other parameters
};

// Plays the recording again and returns every difference, in the order of the ticks.
std::vector<Difference> rejudge(const Recording& recording, const referee::Rules& rules);

}  // namespace mirocup::replay
