// SPDX-License-Identifier: MIT
//
// The goalkeeper is pushed into its goal along with the ball. Source: MiroSot law 8.2: the goal
// does not count and a goal kick is given.
//
// Judged by the last `push_in_s` before the goal: an attacker pressed on the keeper, directly or
// through the ball, while the keeper was moved `push_in_m` towards its goal line; and at the moment
// of the goal the keeper touches the ball or is over the line. If the keeper's own commands took it
// towards the line, the keeper was not pushed.
#pragma once

#include "core/referee/laws/law.hpp"
#include "core/referee/occupancy.hpp"

#include <array>

namespace mirocup::referee {

// One tick of a keeper's recent past.
struct PushInTick {
  double moved = 0.0;         // towards its goal line, m
  double duration = 0.0;      // s
  bool pressed = false;       // by an attacker, or by an attacker through the ball
  bool backs_itself = false;  // its own command takes it towards its goal line
  RobotSet attackers;
};

struct KeeperPushInMemory {
  // The last ticks of each end's keeper, in a ring buffer. 64 ticks last longer than `push_in_s` at
  // any control period in use.
  ByEnd<std::array<PushInTick, 64>> ticks{};
  int next = 0;  // index at which the next tick is stored
  ByEnd<std::optional<RobotId>> keeper;
  ByEnd<double> keeper_x{};
};

// Called in every tick. It decides only in a tick in which the ball crosses the goal line at
// `goal_at`.
std::optional<Decision> judge_keeper_push_in(const JudgedField& pitch, const TickFacts& situation,
                                             const Occupancy& occupancy, std::optional<End> goal_at,
                                             KeeperPushInMemory& memory);

}  // namespace mirocup::referee
