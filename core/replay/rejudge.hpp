// SPDX-License-Identifier: MIT
//
// A played match judged again with other parameters of the laws.
//
// Robots and ball move as they did; a second referee looks on. Where it would have decided
// otherwise play would have gone another way, so every difference is told for the match as it was,
// not for the one that would have been. At each stoppage of the match the second referee begins
// anew with it.
#pragma once

#include "core/replay/recording.hpp"

#include <optional>
#include <vector>

namespace mirocup::replay {

// What one of the two referees decided in a tick and the other did not, or otherwise.
struct Difference {
  std::uint32_t tick = 0;
  std::optional<match::LoggedDecision> given;     // as it was played
  std::optional<match::LoggedDecision> would_be;  // with the other parameters
};

std::vector<Difference> rejudge(const Recording& recording, const referee::Rules& rules);

}  // namespace mirocup::replay
