// SPDX-License-Identifier: MIT
//
// Where everything is and how it moves: plain data, the whole memory of the physics between two
// ticks.
#pragma once

#include "core/field/frames.hpp"
#include "core/field/league.hpp"

#include <array>
#include <bitset>
#include <optional>

namespace mirocup::simulator::inline model {

inline constexpr int max_robots = 2 * max_robots_per_team;
inline constexpr int max_bodies = max_robots + 1;  // and the ball

// Some of the bodies, by index.
using BodySet = std::bitset<max_bodies>;

// Velocities are those of the body frame: forward and to the left in m/s, turning in rad/s.
struct Twist {
  double forward = 0.0;  // v_f
  double left = 0.0;     // v_l, not zero only while the wheels slide sideways
  double omega = 0.0;    // omega
};

// Where a robot or the ball is and how it moves. The ball's frame does not turn (heading +x), so its
// twist is its velocity in the field's frame.
struct BodyState : Pose {
  Twist twist;

  BodyState() = default;
  BodyState(const Vec2& at, const Heading& towards, const Twist& moving)
      : Pose{at, towards}, twist(moving) {}

  Vec2 velocity() const { return heading.to_world({twist.forward, twist.left}); }
};

struct BallState {
  Vec2 position{0.0, 0.0};
  Vec2 velocity{0.0, 0.0};
};

// What a robot's wheels are asked to do until the next command, rad/s. `nothing` lifts the wheels
// off the ground: a free body without motor and grip.
struct WheelSpeeds {
  double left = 0.0;
  double right = 0.0;
};
using WheelCommand = std::optional<WheelSpeeds>;

}  // namespace mirocup::simulator::inline model
