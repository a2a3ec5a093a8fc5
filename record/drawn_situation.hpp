// SPDX-License-Identifier: MIT
//
// JSON in which any number may be a range, {"from": a, "to": b}, from which a seed draws the
// number: the situations of drills and of training.
#pragma once

#include "core/base/error.hpp"
#include "core/base/random.hpp"
#include "record/situation_json.hpp"

#include <nlohmann/json.hpp>

#include <string>

namespace mirocup::record {

// Returns the value with a number in the place of each range, drawn in the order of the document.
nlohmann::ordered_json drawn(const nlohmann::ordered_json& json, Random& random);

// Draws a situation. If bodies overlap, draws again, at most a hundred times. If no draw succeeds,
// returns the error of the last draw, Errc::input, which names `path`.
Result<Situation> draw_situation(const nlohmann::ordered_json& ranges, League league,
                                 Random& random, const std::string& path);

}  // namespace mirocup::record
