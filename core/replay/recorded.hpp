// SPDX-License-Identifier: MIT
//
// The recorded answers of both teams.
#pragma once

#include "core/replay/recording.hpp"

namespace mirocup::replay {

// Returns the answers to the observations of a tick. For the tick after the last recorded one it
// returns the answers that ended the leg: a fault, a failure of the host, or commands of 0.
match::ByTeam<match::Answer> recorded_answers(const Recording& recording, std::uint32_t tick);

}  // namespace mirocup::replay
