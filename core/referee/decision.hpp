// SPDX-License-Identifier: MIT
//
// What the referee says. Every decision names its law, the team, the place, the time and the reason
// with the numbers that decided it.
#pragma once

#include "core/base/names.hpp"
#include "core/referee/situation.hpp"

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace mirocup::referee {

enum class Verdict {
  GOAL,
  KICK_OFF,
  KICK_OFF_VIOLATION,
  PENALTY_KICK,
  GOAL_KICK,
  FREE_BALL,
  HALF_END,
  MATCH_END,
};

enum class Law { toss, kick_off, goal, own_goal, keeper_hold, stalemate, half_time, mercy };

// How play goes on.
enum class Restart { none, KICK_OFF, GOAL_KICK, PENALTY_KICK, FREE_BALL };

struct Decision {
  Verdict verdict = Verdict::GOAL;
  Law law = Law::goal;
  double clock = 0.0;       // match clock, s
  std::optional<End> team;  // who scored, offended, or nobody
  std::string reason;
  Vec2 ball{0.0, 0.0};  // where it was, m
  Restart restart = Restart::none;
  End taker = End::left;  // of the restart; of a free ball, the defender of that half
  Vec2 spot{0.0, 0.0};    // where the ball is put, m
};

}  // namespace mirocup::referee

namespace mirocup {

template <>
inline constexpr std::array<std::string_view, 8> enum_names<referee::Verdict>{
    "GOAL",      "KICK_OFF",  "KICK_OFF_VIOLATION", "PENALTY_KICK",
    "GOAL_KICK", "FREE_BALL", "HALF_END",           "MATCH_END"};
template <>
inline constexpr std::array<std::string_view, 8> enum_names<referee::Law>{
    "toss", "kick_off", "goal", "own_goal", "keeper_hold", "stalemate", "half_time", "mercy"};
template <>
inline constexpr std::array<std::string_view, 5> enum_names<referee::Restart>{
    "none", "KICK_OFF", "GOAL_KICK", "PENALTY_KICK", "FREE_BALL"};

}  // namespace mirocup
