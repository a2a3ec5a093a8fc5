// SPDX-License-Identifier: MIT
//
// Numbers that the host of a leg gives a team, by name: `--param wait=0.4`. A leg does not know
// them: its controller hands them over when it starts the team.
#pragma once

#include <algorithm>
#include <cstddef>
#include <map>
#include <string>
#include <string_view>

namespace mirocup::match {

// The value of each name, in the unit that the team gives it.
using TeamParameters = std::map<std::string, double>;

inline constexpr std::size_t max_team_parameters = 32;
inline constexpr std::size_t max_parameter_name = 31;  // bytes

// True for a name that has only letters, digits, '_', '-' and '.', and begins with a letter.
inline bool is_parameter_name(std::string_view name) {
  const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  return !name.empty() && name.size() <= max_parameter_name && is_letter(name[0]) &&
         std::all_of(name.begin(), name.end(), [&](char c) {
           return is_letter(c) || (c >= '0' && c <= '9') || c == '_' || c == '-' || c == '.';
         });
}

// Returns why a team cannot have these parameters, as a part of a sentence; "" if it can. A value
// must be finite.
std::string problem_with(const TeamParameters& parameters);

}  // namespace mirocup::match
