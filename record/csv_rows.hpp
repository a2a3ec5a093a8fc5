// SPDX-License-Identifier: MIT
//
// The rows of a report as comma-separated values, from the same JSON that programs read.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace mirocup::record {

// Returns a line of titles and a line for each object in `rows`. A column is the key of a value,
// or "title=path" with the keys on the way to the value, as in "home_goals=score/home". A missing
// value, null or "" makes an empty cell; true and false become yes and no; the values of an array
// are separated by blanks.
std::string csv_of(const nlohmann::ordered_json& rows, const std::vector<std::string>& columns);

}  // namespace mirocup::record
