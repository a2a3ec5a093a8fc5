// SPDX-License-Identifier: MIT
//
// What the JSON of records and of statistics have in common: values of a leg.
#pragma once

#include "core/base/state_hash.hpp"
#include "core/match/goal_credit.hpp"
#include "record/json_fields.hpp"
#include "system/number_of.hpp"

namespace mirocup::record {

void list_fields(auto& f, match::Touch& touch) {
  f("team", touch.team);
  f("robot", touch.robot, 0, max_robots_per_team - 1);
}

// A state hash, 16 hexadecimal digits.
void list_hash(auto& f, const char* key, std::uint64_t& hash) {
  f.as(
      key, [&] { return to_hex(hash); },
      [&](const JsonReader& json) {
        const std::string digits = json.text();
        const auto read = system::hexadecimal_of<std::uint64_t>(digits);
        if (!read || digits.size() != 16)
          json.complain("16 hexadecimal digits are expected, not " + json.quoted());
        hash = read.value_or(0);
      });
}

}  // namespace mirocup::record
