// SPDX-License-Identifier: MIT
//
// Pitches as JSON, schema mirocup/pitch/1, in files, league files and records: docs/pitches.md.
#pragma once

#include "core/base/error.hpp"
#include "core/match/pitch_spec.hpp"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <string_view>

namespace mirocup::record {

class JsonReader;

// The range of the control periods with which a leg can be played, s.
inline constexpr double min_control_period = 1e-3;
inline constexpr double max_control_period = 1.0;

// Returns an object from which read_pitch() makes the same pitch.
nlohmann::ordered_json to_json(const match::PitchSpec& pitch);

// Reads the name of a preset, or an object. Values that an object leaves out come from the preset
// of its key "preset", by default mirosot. Complains about an unknown key, a wrong type, and
// impossible parameters of a robot.
match::PitchSpec read_pitch(const JsonReader& json);

// Reads a pitch from the text of a file. The error, Errc::input, names `path`, the JSON pointer and
// the reason.
Result<match::PitchSpec> parse_pitch(std::string_view text, const std::string& path);

// Returns the pitch that the value of the option --pitch gives: the name of a preset, a file, or
// the JSON text itself, which begins with "{". Errors: Errc::input, Errc::unavailable for a file.
Result<match::PitchSpec> pitch_of_option(const std::string& option);

}  // namespace mirocup::record
