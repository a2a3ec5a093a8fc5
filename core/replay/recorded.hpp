// SPDX-License-Identifier: MIT
//
// Both teams' answers as they were recorded.
#pragma once

#include "core/replay/recording.hpp"

namespace mirocup::replay {

// The answers to the observations of a tick; after the last recorded one, what ended the leg.
match::ByTeam<match::Answer> recorded_answers(const Recording& recording, std::uint32_t tick);

}  // namespace mirocup::replay
