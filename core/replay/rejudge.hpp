// SPDX-License-Identifier: MIT
//
// A played leg judged again with other parameters of the laws.
//
// Robots and ball move as recorded, while a second referee judges the same situations. After a
// different decision a real leg would have taken another course. Here the recorded motion
// continues, so a difference says only how that moment of the recording would have been judged. At
// each stoppage of the leg the second referee takes over the state of the first referee.
#pragma once

#include "core/replay/playback.hpp"

#include <tl/expected.hpp>

#include <optional>
#include <vector>

namespace mirocup::replay {

// A tick in which the two referees decided differently.
struct Difference {
  std::uint32_t tick = 0;
  std::optional<match::LoggedDecision> given;     // as it was played
  std::optional<match::LoggedDecision> would_be;  // with the other parameters
};

// Plays the recording again and returns every difference, in the order of the ticks. The error is
// that of verify(): the recording is not reproduced.
tl::expected<std::vector<Difference>, Divergence> rejudge(const Recording& recording,
                                                          const referee::Rules& rules);

}  // namespace mirocup::replay
