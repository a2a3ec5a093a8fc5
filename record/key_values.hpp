// SPDX-License-Identifier: MIT
//
// KEY=VALUE from a command line, for --rule and --condition.
#pragma once

#include "core/base/error.hpp"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace mirocup::record {

// Returns the object with changes; each change is KEY=VALUE with a value in JSON. Errors:
// Errc::input, which names the option.
Result<nlohmann::ordered_json> with_changes(nlohmann::ordered_json object,
                                            const std::vector<std::string>& changes,
                                            const std::string& option);

}  // namespace mirocup::record
