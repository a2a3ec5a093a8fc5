// SPDX-License-Identifier: MIT
//
// The three MiroSot leagues: small (3 a side), middle (5 a side), large (11 a side).
#pragma once

#include "core/base/names.hpp"

#include <array>
#include <string_view>

namespace mirocup {

enum class RobotLeague { small, middle, large };

template <>
inline constexpr std::array<std::string_view, 3> enum_names<RobotLeague>{"small", "middle",
                                                                         "large"};
// Messages to teams hold the numbers of these enumerators.
static_assert(is_numbered_in_order<RobotLeague::small, RobotLeague::middle, RobotLeague::large>());

// The number of robots of a team in the largest league. Arrays of robots have this size.
inline constexpr int max_robots_per_team = 11;

}  // namespace mirocup
