// SPDX-License-Identifier: MIT
//
// The parameters of the laws as JSON, in records and in league files. A limit that is off is null,
// a count that is off 0.
#pragma once

#include "core/base/error.hpp"
#include "core/referee/rules.hpp"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace mirocup::record {

nlohmann::ordered_json to_json(const referee::Rules& rules);

// Starts from the preset that the object names (or mirosot), as it is in that league, and applies
// the other keys. An unknown key or a wrong type is an error of `code` that names it.
Result<referee::Rules> rules_from_json(const nlohmann::ordered_json& object, Errc code,
                                       League league);

// The same with changes from a command line, each KEY=VALUE with a value of JSON. Errors of usage.
Result<referee::Rules> rules_with_changes(nlohmann::ordered_json object,
                                          const std::vector<std::string>& changes, League league);

}  // namespace mirocup::record
