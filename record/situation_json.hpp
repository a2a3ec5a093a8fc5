// SPDX-License-Identifier: MIT
//
// The start of a leg as JSON: a situation, "mirocup/situation/1". docs/situations.md specifies it.
// A file that a person writes and the key "situation" of a record have this form.
#pragma once

#include "core/base/error.hpp"
#include "core/base/random.hpp"
#include "core/field/league.hpp"
#include "core/match/start.hpp"

#include <nlohmann/json.hpp>

#include <string>
#include <string_view>

namespace mirocup::record {

class JsonReader;

struct Situation {
  RobotLeague league = RobotLeague::small;
  match::Start start;
};

// Bodies may overlap by this much, m, because a page that saves a moment rounds places to half a
// millimetre. The first tick separates the bodies.
inline constexpr double max_start_overlap = 1e-3;

// Returns a situation with all values; headings are [cos, sin], so that no bit is lost.
nlohmann::ordered_json to_json(const Situation& situation);

// Complains about an unknown key, a wrong type, a number out of its range, and bodies that overlap
// by more than max_start_overlap, with their names. After a complaint the situation must not be
// played.
Situation read_situation(const JsonReader& json);

// Like read_situation(), for the text of a file. Errors: Errc::input.
Result<Situation> parse_situation(std::string_view text, const std::string& path);

// JSON in which any number may be a range, {"from": a, "to": b}, from which a seed draws the
// number: the situations of drills and of training.

// Returns the value with a number in the place of each range, drawn in the order of the document.
nlohmann::ordered_json drawn(const nlohmann::ordered_json& json, Random& random);

// Draws a situation. If bodies overlap, draws again, at most a hundred times. If no draw succeeds,
// returns the error of the last draw, Errc::input, which names `path`.
Result<Situation> draw_situation(const nlohmann::ordered_json& ranges, RobotLeague league,
                                 Random& random, const std::string& path);

}  // namespace mirocup::record
