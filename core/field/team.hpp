// SPDX-License-Identifier: MIT
//
// The two teams of a leg. A team keeps its colour for the whole leg; the end that it defends
// changes at half-time (frames.hpp).
#pragma once

#include "core/base/names.hpp"

#include <array>
#include <string_view>

namespace mirocup {

enum class Team { blue, yellow };

template <>
inline constexpr std::array<std::string_view, 2> enum_names<Team>{"blue", "yellow"};

constexpr Team opponent_of(Team team) {
  return team == Team::blue ? Team::yellow : Team::blue;
}

// 0 for blue, 1 for yellow: the index in arrays, and the number in records and messages.
constexpr int index_of(Team team) {
  return static_cast<int>(team);
}
static_assert(is_numbered_in_order<Team::blue, Team::yellow>());

inline constexpr std::array<Team, 2> both_teams{Team::blue, Team::yellow};

}  // namespace mirocup
