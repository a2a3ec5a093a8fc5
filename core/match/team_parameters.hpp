// SPDX-License-Identifier: MIT
//
// Numbers that the host of a leg gives a team, by name: `--param wait=0.4`. A leg does not know
// them: its controller hands them over when it starts the team.
#pragma once

#include <cstddef>
#include <map>
#include <string>

namespace mirocup::match {

// The value of each name, in the unit that the team gives it.
using TeamParameters = std::map<std::string, double>;

inline constexpr std::size_t max_team_parameters = 32;
inline constexpr std::size_t max_parameter_name = 31;  // bytes

// Returns why a team cannot have these parameters, as a part of a sentence; "" if it can. A name
// has only letters, digits, '_', '-' and '.', and begins with a letter. A value must be finite.
std::string problem_with(const TeamParameters& parameters);

}  // namespace mirocup::match
