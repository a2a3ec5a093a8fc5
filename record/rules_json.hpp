// SPDX-License-Identifier: MIT
//
// The parameters of the laws as JSON, in records, league files and situations: {"preset": NAME,
// KEY: VALUE, …}. A limit that is switched off is null; a count that is switched off is 0.
#pragma once

#include "core/base/error.hpp"
#include "core/referee/rules.hpp"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace mirocup::record {

class JsonReader;

// The shortest half that an option may give, and the longest with which a leg can be played, s.
inline constexpr double min_half_s = 0.1;
inline constexpr double max_half_s = 36'000.0;

nlohmann::ordered_json to_json(const referee::Rules& rules);

// Starts from the preset that the object names (default: mirosot), with its values for `league`,
// and applies the other keys. Complains about an unknown key, a wrong type and a negative number.
referee::Rules read_rules(const JsonReader& json, RobotLeague league);

// Applies all keys of the object but "preset" to `rules`.
void read_parameters(const JsonReader& json, referee::Rules& rules);

// Like read_rules(), with changes from a command line: each change is KEY=VALUE with a value in
// JSON. The error, Errc::input, begins with the JSON pointer: "/rules/half_s: ...".
Result<referee::Rules> rules_with_changes(nlohmann::ordered_json object,
                                          const std::vector<std::string>& changes,
                                          RobotLeague league);

}  // namespace mirocup::record
