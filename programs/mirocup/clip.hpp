// SPDX-License-Identifier: MIT
//
// A part of a leg as a video: `mirocup replay RECORD --clip FROM:TO -o FILE`.
#pragma once

#include "core/base/error.hpp"
#include "record/match_record.hpp"

#include <string>

namespace mirocup::app {

// A part of a leg, in seconds since it began.
struct ClipSpan {
  double from = 0.0;
  double to = 0.0;
};

inline constexpr double max_clip_s = 60.0;

// Reads "12:18" or "12.5:18". Errors: Errc::input if the text has another form, or if the part ends
// before it begins or is longer than max_clip_s.
Result<ClipSpan> parse_clip(const std::string& text);

// True if the name of a file ends like that of a video: in .webm, .mp4 or .gif.
bool is_video_name(const std::string& path);

// Draws the part of the leg tick by tick and lets ffmpeg, which must be installed, make a video
// that plays in real time. The pictures are in a temporary folder beside `output`. Errors:
// Errc::input if the leg has ended before `from`; Errc::damaged if the record is not reproduced;
// Errc::unavailable if ffmpeg is missing or fails.
Result<void> write_clip(system::Files& files, const record::MatchRecord& record,
                        const ClipSpan& span, const std::string& output);

}  // namespace mirocup::app
