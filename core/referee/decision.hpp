// SPDX-License-Identifier: MIT
//
// What the referee says. Every decision names its law, the team, the robots, the place, the time
// and the reason with the numbers that decided it.
#pragma once

#include "core/base/names.hpp"
#include "core/referee/situation.hpp"

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace mirocup::referee {

enum class Verdict {
  NONE,  // noted, without effect
  GOAL,
  KICK_OFF,
  KICK_OFF_VIOLATION,
  PENALTY_KICK,
  GOAL_KICK,
  FREE_KICK,
  FREE_BALL,
  HALF_END,
  PHASE,  // extra time or the shoot-out begins
  ATTEMPT_END,
  PLACEMENT_FIXED,
  RESTART,
  TIME_OUT,
  SUBSTITUTION,
  REJECTED,
  FORFEIT,
  MATCH_END,
};

// One file each in laws/; `forfeit` is the match's.
enum class Law {
  toss,
  kick_off,
  goal,
  own_goal,
  two_defenders,
  four_defenders,
  two_attackers,
  four_attackers,
  keeper_hold,
  keeper_charge,
  keeper_push_in,
  keeper_block,
  keeper_catch,
  stalemate,
  push,
  attacking_push,
  collision,
  holding,
  wall_push,
  hand,
  fallen,
  placement,
  half_time,
  golden_goal,
  extra_time,
  penalty_attempt,
  shoot_out,
  lots,
  mercy,
  time_out,
  substitution,
  forfeit,
};

enum class Phase { FIRST_HALF, SECOND_HALF, EXTRA, SHOOT_OUT };

// How play goes on.
enum class Restart { none, KICK_OFF, GOAL_KICK, PENALTY_KICK, FREE_BALL, FREE_KICK };

struct Decision {
  Verdict verdict = Verdict::NONE;
  Law law = Law::goal;
  double clock = 0.0;       // match clock, s
  std::optional<End> team;  // who scored, offended, won, or nobody
  ByEnd<RobotSet> robots;   // who had a part in it
  std::string reason;
  Vec2 ball{0.0, 0.0};  // where it was, m
  Restart restart = Restart::none;
  End taker = End::left;            // of the restart; of a free ball, the defender of that half
  Vec2 spot{0.0, 0.0};              // where a free ball is put, m
  Phase phase = Phase::FIRST_HALF;  // that begins: HALF_END, PHASE
  bool goal_cancelled = false;
  bool scored = false;  // ATTEMPT_END

  void add_robot(const RobotId& robot) { robots[index_of(robot.end)].set(robot.index); }
};

}  // namespace mirocup::referee

namespace mirocup {

template <>
inline constexpr std::array<std::string_view, 18> enum_names<referee::Verdict>{
    "NONE",         "GOAL",      "KICK_OFF",     "KICK_OFF_VIOLATION",
    "PENALTY_KICK", "GOAL_KICK", "FREE_KICK",    "FREE_BALL",
    "HALF_END",     "PHASE",     "ATTEMPT_END",  "PLACEMENT_FIXED",
    "RESTART",      "TIME_OUT",  "SUBSTITUTION", "REJECTED",
    "FORFEIT",      "MATCH_END"};
template <>
inline constexpr std::array<std::string_view, 32> enum_names<referee::Law>{
    "toss",          "kick_off",        "goal",           "own_goal",
    "two_defenders", "four_defenders",  "two_attackers",  "four_attackers",
    "keeper_hold",   "keeper_charge",   "keeper_push_in", "keeper_block",
    "keeper_catch",  "stalemate",       "push",           "attacking_push",
    "collision",     "holding",         "wall_push",      "hand",
    "fallen",        "placement",       "half_time",      "golden_goal",
    "extra_time",    "penalty_attempt", "shoot_out",      "lots",
    "mercy",         "time_out",        "substitution",   "forfeit"};
template <>
inline constexpr std::array<std::string_view, 4> enum_names<referee::Phase>{
    "FIRST_HALF", "SECOND_HALF", "EXTRA", "SHOOT_OUT"};
// Messages to teams hold the numbers of phases and restarts.
static_assert(is_numbered_in_order<referee::Phase::FIRST_HALF, referee::Phase::SECOND_HALF,
                                   referee::Phase::EXTRA, referee::Phase::SHOOT_OUT>());
template <>
inline constexpr std::array<std::string_view, 6> enum_names<referee::Restart>{
    "none", "KICK_OFF", "GOAL_KICK", "PENALTY_KICK", "FREE_BALL", "FREE_KICK"};
static_assert(is_numbered_in_order<referee::Restart::none, referee::Restart::KICK_OFF,
                                   referee::Restart::GOAL_KICK, referee::Restart::PENALTY_KICK,
                                   referee::Restart::FREE_BALL, referee::Restart::FREE_KICK>());

}  // namespace mirocup
