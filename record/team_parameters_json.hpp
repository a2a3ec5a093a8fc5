// SPDX-License-Identifier: MIT
//
// The parameters of a team in records and league files, {"wait": 0.4}, and on command lines,
// `--param wait=0.4`.
#pragma once

#include "core/base/error.hpp"
#include "core/match/team_parameters.hpp"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace mirocup::record {

class JsonReader;

nlohmann::ordered_json to_json(const match::TeamParameters& parameters);

// Complains about parameters that no team can have.
match::TeamParameters read_team_parameters(const JsonReader& json);

// Returns the parameters with changes from a command line: each change is KEY=VALUE; if a name
// comes twice, the last value counts. Errors: Errc::input, which names `option`.
Result<match::TeamParameters> parameters_with_changes(match::TeamParameters parameters,
                                                      const std::vector<std::string>& changes,
                                                      const std::string& option);

// Converts parameters to arguments of a command line: `option`, KEY=VALUE, and so on.
std::vector<std::string> parameter_options(const match::TeamParameters& parameters,
                                           const std::string& option);

}  // namespace mirocup::record
