// SPDX-License-Identifier: MIT
//
// The decisions of the referee. Every decision names its law, the team, the robots, the place, the
// time, and the reason with the numbers that decided it.
#pragma once

#include "core/base/names.hpp"
#include "core/referee/tick_facts.hpp"

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
  PHASE,  // extra time or the shoot-out starts
  ATTEMPT_END,
  PLACEMENT_FIXED,
  RESTART,
  TIME_OUT,
  SUBSTITUTION,
  REJECTED,
  FORFEIT,
  MATCH_END,
};

// The laws of play have a file each in laws/ (the four about crowded areas share one). The referee
// and the placement apply the other laws; the match applies `forfeit`.
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

// The ways in which play is resumed.
enum class Restart { none, KICK_OFF, GOAL_KICK, PENALTY_KICK, FREE_BALL, FREE_KICK };

struct Decision {
  Verdict verdict = Verdict::NONE;
  Law law = Law::goal;
  double clock = 0.0;       // of the phase, s
  std::optional<End> team;  // the team that scored, offended or won; nothing if there is none
  ByEnd<RobotSet> robots;   // the robots involved
  std::string reason;       // a clause with numbers, for records and spectators
  Vec2 ball{0.0, 0.0};      // where the ball was at the decision, m
  Restart restart = Restart::none;
  End taker = End::left;            // takes the restart; at a free ball the spot is in its half
  Vec2 spot{0.0, 0.0};              // where the ball is put, m
  Phase phase = Phase::FIRST_HALF;  // the phase that begins, for HALF_END and PHASE
  bool goal_cancelled = false;      // a goal of the same tick does not count
  bool scored = false;              // for ATTEMPT_END: the attempt was a goal

  // Adds a robot to the robots involved.
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
