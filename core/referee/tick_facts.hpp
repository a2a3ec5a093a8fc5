// SPDX-License-Identifier: MIT
//
// The situation of one tick, which the laws judge.
//
// A situation is plain data: it comes from a simulated world, from a recorded trace of a real
// pitch, or from a test. It knows ends, not colours: the team that defends the left end attacks +x.
// Everything is in the field's frame; metres, seconds, m/s.
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

// A value for each end, or for the team that defends it: [index_of(End::left)] is at x < 0.
template <class T>
using ByEnd = std::array<T, 2>;

// A value for each robot: [index_of(end)][index].
template <class T>
using ByRobot = ByEnd<std::array<T, max_robots_per_team>>;

struct TickFacts {
  double begin = 0.0;     // clock of the phase at the start of the tick, s; set by the referee
  double duration = 0.0;  // of the tick, s; 0 for the first frame of a camera

  Vec2 ball_before{0.0, 0.0};  // at the start of the tick; laws assume a straight line to `ball`
  Vec2 ball{0.0, 0.0};         // at the end of the tick
  ByRobot<Pose> robots;        // at the end of the tick

  // The velocity at the start of the tick, before any impact in it, and the commanded velocity,
  // which the wheel command gives along the heading at the tick's end.
  ByRobot<Vec2> velocity{};
  ByRobot<Vec2> commanded{};

  // Touches: contacts during the tick, and gaps of at most Rules::touch_m at its end.
  ByEnd<RobotSet> touched_ball;
  ByRobot<RobotSet> touched_opponents;  // by robot: the opponents that it touched; symmetric
  ByRobot<RobotSet> touched_mates;      // by robot: the team-mates; symmetric
  // The last robot that touched the ball, in this tick or before.
  std::optional<RobotId> last_touch;

  ByEnd<bool> hand{};      // true if the team reached onto the field in this tick
  ByEnd<RobotSet> fallen;  // robots that lie on their side: in recorded traces only

  const Pose& pose(const RobotId& id) const { return robots[index_of(id.end)][id.index]; }
  bool touches_ball(const RobotId& id) const { return touched_ball[index_of(id.end)][id.index]; }
  bool touch(const RobotId& robot, int opponent) const {
    return touched_opponents[index_of(robot.end)][robot.index][opponent];
  }
};

}  // namespace mirocup::referee
