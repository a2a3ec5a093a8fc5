// SPDX-License-Identifier: MIT
//
// Pushing an opponent. Sources: MiroSot laws 8.1 and 10.
//
// Intent is judged by what can be measured: a robot that does not touch the ball drives at an
// opponent that does not drive back, and moves this opponent by `push_dist_m` away from itself. A
// push by the defending side is a free kick for the other team. For a push by the attacking side
// the texts name no restart: it is a goal kick if the ball is in the defenders' goal area, else a
// free ball. Other laws protect the keeper in its goal area.
#pragma once

#include "core/referee/laws/law.hpp"
#include "core/referee/occupancy.hpp"

#include <array>

namespace mirocup::referee {

// A pair of a pusher and a pushed robot.
struct Push {
  bool is_on = false;
  Vec2 from{0.0, 0.0};   // where the pushed robot was when the push began, m
  double muted_s = 0.0;  // time for which the pair is not called again, s
};

struct PushMemory {
  // By pusher and pushed: [index_of(pusher's end)][pusher][pushed].
  ByEnd<std::array<std::array<Push, max_robots_per_team>, max_robots_per_team>> pairs{};
  // By pusher: the opponents that it pushes, and those of a muted pair (Push::muted_s).
  ByRobot<RobotSet> on{};
};

// Returns the decision about a push. The pusher's team defends if the ball is in its half or was
// last touched by the pushed team. `reason` says what the pusher did; the function adds whether its
// team defended or attacked.
Decision call_push(const JudgedField& pitch, const TickFacts& situation, const RobotId& pusher,
                   const RobotId& pushed, std::string reason);

// Returns the call of at most one push. It ignores the advantage: judge_play() decides whether the
// call of a push by the defending side waits.
std::optional<Decision> judge_push(const JudgedField& pitch, const TickFacts& situation,
                                   const Occupancy& occupancy, PushMemory& memory);

}  // namespace mirocup::referee
