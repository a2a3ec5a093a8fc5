// SPDX-License-Identifier: MIT
//
// The goalkeeper is pushed into its goal along with the ball. Source: MiroSot law 8.2, the goal
// does not count and a goal kick is given. Judged by looking back from the goal: an attacker
// pressed on the keeper, itself or through the ball, while the keeper was moved towards its line,
// and the keeper is at the ball or over the line when it falls.
#pragma once

#include "core/referee/laws/law.hpp"
#include "core/referee/occupancy.hpp"

#include <array>

namespace mirocup::referee {

// One tick of a push: how far the keeper was moved towards its goal line, m.
struct PushInTick {
  double moved = 0.0;
  double duration = 0.0;
  bool pressed = false;       // attacker to keeper, or attacker to ball to keeper
  bool backs_itself = false;  // the keeper's own command takes it there
  RobotSet attackers;
};

struct KeeperPushInMemory {
  // The last ticks of each end, in a ring; as many as any control period has in the time looked
  // back.
  ByEnd<std::array<PushInTick, 64>> ticks{};
  int next = 0;
  ByEnd<std::optional<RobotId>> keeper;
  ByEnd<double> keeper_x{};
};

// Looks at every tick; calls it only if the ball crosses the goal at `goal_at`.
std::optional<Decision> judge_keeper_push_in(const Pitch& pitch, const Situation& situation,
                                             const Occupancy& occupancy, std::optional<End> goal_at,
                                             KeeperPushInMemory& memory);

}  // namespace mirocup::referee
