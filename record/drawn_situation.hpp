// SPDX-License-Identifier: MIT
//
// JSON in which any number may be a range, {"from": a, "to": b}, out of which a seed draws one:
// the situations of drills and of training.
#pragma once

#include "core/base/error.hpp"
#include "core/base/random.hpp"
#include "record/situation_json.hpp"

#include <nlohmann/json.hpp>

#include <string>

namespace mirocup::record {

// Returns the value with a number in the place of each range, drawn in the order of the document.
nlohmann::ordered_json drawn(const nlohmann::ordered_json& json, Random& random);

// Draws a situation. One whose bodies overlap is drawn again, a hundred times at most; the error of
// the last one is Errc::input and names `path`.
Result<Situation> draw_situation(const nlohmann::ordered_json& ranges, League league,
                                 Random& random, const std::string& path);

}  // namespace mirocup::record
