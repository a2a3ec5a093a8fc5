// SPDX-License-Identifier: MIT
//
// One tick as the laws see it. Ends, not colours: the defender of left attacks +x. A situation is
// plain data: it comes from a simulated world, from a film of a real pitch, or from a test.
#pragma once

#include "core/field/field.hpp"

#include <array>
#include <bitset>
#include <optional>

namespace mirocup::referee {

using RobotSet = std::bitset<max_robots_per_team>;

struct RobotId {
  End end = End::left;
  int index = 0;

  bool operator==(const RobotId&) const = default;
};

// By end: [index_of(End::left)] is the team that defends x < 0.
template <class T>
using ByEnd = std::array<T, 2>;

struct Situation {
  double begin = 0.0;     // match clock at the begin of the tick, s
  double duration = 0.0;  // of the tick, s

  Vec2 ball_before{0.0, 0.0};  // m, at the begin; between them the ball moves on a straight line
  Vec2 ball{0.0, 0.0};         // at the end
  ByEnd<std::array<Pose, max_robots_per_team>> robots;

  ByEnd<RobotSet> touched_ball;  // at some time of the tick
  std::optional<RobotId>
      last_touch;  // the last robot that touched the ball, in this tick or before
  ByEnd<std::array<Vec2, max_robots_per_team>>
      commanded{};  // velocity that its wheels are asked for, m/s
};

}  // namespace mirocup::referee
