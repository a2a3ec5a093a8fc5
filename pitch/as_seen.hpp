// SPDX-License-Identifier: MIT
//
// A played leg as a camera would have recorded it.
#pragma once

#include "core/replay/recording.hpp"
#include "pitch/recording.hpp"

namespace mirocup::pitch {

// Plays the leg again and returns a recording with a picture at the start of each tick, without
// noise. A frame has the commands that drive the robots in that tick; while play is stopped, the
// commands are 0. Errc::damaged if the leg differs from its record.
Result<Recording> as_seen(const replay::Recording& leg, const std::string& path);

}  // namespace mirocup::pitch
