// SPDX-License-Identifier: MIT
//
// Poses and twists of all bodies, and the commands of their wheels: plain data. SI units, angles in
// radians, counter-clockwise.
#pragma once

#include "core/field/frames.hpp"
#include "core/field/league.hpp"

#include <array>
#include <bitset>
#include <optional>

namespace mirocup::simulator {
inline namespace model {

inline constexpr int max_robots = 2 * max_robots_per_team;
inline constexpr int max_bodies = max_robots + 1;  // and the ball

// A set of bodies, by index: the robots from 0, then the ball.
using BodySet = std::bitset<max_bodies>;

// The velocities of a body in its own frame. For a robot, `left` differs from zero only while its
// wheels slide sideways.
struct Twist {
  double forward = 0.0;  // m/s, v_f
  double left = 0.0;     // m/s, v_l
  double omega = 0.0;    // rad/s
};

// Pose and twist of a robot or the ball. The ball's frame does not turn (heading +x), so its twist
// is its velocity in the field's frame.
struct BodyState : Pose {
  Twist twist;

  BodyState() = default;
  BodyState(const Vec2& at, const Heading& towards, const Twist& moving)
      : Pose{at, towards}, twist(moving) {}

  // Returns the velocity of the reference point in the field's frame, m/s.
  Vec2 velocity() const { return heading.to_world({twist.forward, twist.left}); }
};

// Position (m) and velocity (m/s) of the ball in the field's frame.
struct BallState {
  Vec2 position{0.0, 0.0};
  Vec2 velocity{0.0, 0.0};
};

// Speeds of a robot's wheels, rad/s.
struct WheelSpeeds {
  double left = 0.0;
  double right = 0.0;
};
// The command of a robot until the next one. An empty command lifts the wheels off the ground: the
// robot is then a free body without motor and grip.
using WheelCommand = std::optional<WheelSpeeds>;

}  // namespace model
}  // namespace mirocup::simulator
