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

template <class T>
using ByRobot = ByEnd<std::array<T, max_robots_per_team>>;

struct Situation {
  double begin = 0.0;     // match clock at the begin of the tick, s
  double duration = 0.0;  // of the tick, s; 0 for what a camera sees first

  Vec2 ball_before{0.0, 0.0};  // m, at the begin; between them the ball moves on a straight line
  Vec2 ball{0.0, 0.0};         // at the end
  ByRobot<Pose> robots;        // at the end

  // m/s: before anything was hit in this tick, and as asked of the wheels.
  ByRobot<Vec2> velocity{};
  ByRobot<Vec2> commanded{};

  // Touches at some time of the tick, or within the touching distance at its end (touches.hpp).
  ByEnd<RobotSet> touched_ball;
  ByRobot<RobotSet> touched_opponents;  // symmetric: the set of each robot's opponents
  ByRobot<RobotSet> touched_mates;      // symmetric, too
  // The last robot that touched the ball, in this tick or before.
  std::optional<RobotId> last_touch;

  ByEnd<bool> hand{};      // somebody of the team reached onto the field in this tick
  ByEnd<RobotSet> fallen;  // robots that lie on their side: in films only

  const Pose& pose(const RobotId& id) const { return robots[index_of(id.end)][id.index]; }
  bool touches_ball(const RobotId& id) const { return touched_ball[index_of(id.end)][id.index]; }
  bool touch(const RobotId& robot, int opponent) const {
    return touched_opponents[index_of(robot.end)][robot.index][opponent];
  }
};

}  // namespace mirocup::referee
