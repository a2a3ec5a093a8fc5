// SPDX-License-Identifier: MIT
//
// The parameters of the laws as JSON, in records and in league files. A limit that is off is null,
// a count that is off 0.
#pragma once

#include "core/base/error.hpp"
#include "core/referee/rules.hpp"

#include <nlohmann/json.hpp>

namespace mirocup::record {

nlohmann::ordered_json to_json(const referee::Rules& rules);

// Starts from the preset that the object names (or mirosot), as it is in that league, and applies
// the other keys. An unknown key or a wrong type is an error of `code` that names it.
Result<referee::Rules> rules_from_json(const nlohmann::ordered_json& object, Errc code,
                                       League league);

}  // namespace mirocup::record
