// SPDX-License-Identifier: MIT
//
// The conditions of a leg as JSON, in records, league files and journals: the name of a preset, or
// {"preset": NAME, KEY: VALUE, …}. The keys are those of match::Conditions.
#pragma once

#include "core/base/error.hpp"
#include "core/match/conditions.hpp"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace mirocup::record {

class JsonReader;

// Returns an object with the preset and every value.
nlohmann::ordered_json to_json(const match::Conditions& conditions);

// Starts from the preset that the value names (default: match::default_preset) and applies the
// other keys. Complains about an unknown key, a wrong type and a number out of its range.
match::Conditions read_conditions(const JsonReader& json);

// Returns the preset with changes from a command line: each is KEY=VALUE with a value in JSON.
// Errors: Errc::input.
Result<match::Conditions> conditions_with_changes(match::ConditionsPreset preset,
                                                  const std::vector<std::string>& changes);

}  // namespace mirocup::record
