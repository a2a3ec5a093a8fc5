// SPDX-License-Identifier: MIT
//
// Results as JSON: the pitch file of an identification, and the object that `validate --json`
// prints.
#pragma once

#include "core/match/pitch_spec.hpp"
#include "pitch/identify.hpp"
#include "pitch/validate.hpp"

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace mirocup::pitch {

// Returns a file of schema mirocup/pitch/1. Identified numbers have {"value", "low", "high"}; other
// numbers have the values of `start`, and "not_known" gives the reason for each. `name` is the name
// of the pitch.
nlohmann::ordered_json pitch_json(const Identified& identified, const match::PitchSpec& start,
                                  const std::string& name);

nlohmann::ordered_json to_json(const Validation& validation);

}  // namespace mirocup::pitch
