// SPDX-License-Identifier: MIT
//
// A played leg as a camera would have recorded it.
#pragma once

#include "core/replay/recording.hpp"
#include "pitch/recording.hpp"

namespace mirocup::pitch {

// Plays the leg again and returns a recording with a picture at the start of each tick, without
// noise. The commands of a frame are those that drive the robots in that tick; while play is
// stopped, robots are commanded to stand. Errc::damaged if the leg differs from its record.
Result<Recording> as_seen(const replay::Recording& leg, const std::string& path);

}  // namespace mirocup::pitch
