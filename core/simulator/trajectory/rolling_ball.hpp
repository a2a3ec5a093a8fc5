// SPDX-License-Identifier: MIT
//
// The ball alone: it rolls without slipping and brakes along its own direction until it stops.
//
//   ds/dt = -(f_v s + K_c m g) / m',  m' = 7m/5        (6), (7), (8) with the paper's errata
//
// The speed s is one exponential, so the time at which it is zero is known in closed form; from
// there on the ball lies still.
//
// The paper's own form, RollingFriction::per_axis, brakes x and y separately (8), with a resistance
// that falls linearly below the speed k (9), so the ball never quite stops. It is there for
// comparison.
#pragma once

#include "core/simulator/model/parameters.hpp"
#include "core/simulator/trajectory/segment.hpp"

namespace mirocup::simulator::trajectory {

// The constants of ds/dt = -constant - linear * s.
struct RollingDeceleration {
  double constant = 0.0;        // K_c m g / m', m/s^2
  double linear = 0.0;          // f_v / m', 1/s
  double per_axis_below = 0.0;  // k, m/s; 0: isotropic

  bool is_per_axis() const { return per_axis_below > 0.0; }
  // Along an axis slower than k: dv/dt = -slow_rate() * v.
  double slow_rate() const { return linear + constant / per_axis_below; }
};
RollingDeceleration rolling_deceleration(const Parameters& parameters);

// Seconds until a ball of speed `speed` stops: ln(1 + linear s / constant) / linear, or never.
double stopping_time(const RollingDeceleration& d, double speed);

// A ball in contact that is slower than this (m/s) lies still.
inline constexpr double roll_round_off = 1e-10;

// The direction in which a ball brakes while something pushes it, as series. Below
// `min_speed_with_direction` it is kept fixed: it is not smooth where the speed is zero.
inline constexpr double min_speed_with_direction = 1e-3;  // m/s
struct Braking {
  bool is_fixed = false;
  Series x,
      y;  // unit vector of the motion; per axis, the sign of each component that is at least k
  Series speed;
  bool x_is_slow = false, y_is_slow = false;  // per axis, below k
};

// Unit vector of `velocity` if it is fast enough to have one of its own, else of `push`, else zero.
Braking braking_along(const RollingDeceleration& d, const Vec2& velocity, const Vec2& push);

// When a ball in contact has to be looked at again, in seconds from the begin of its segment and at
// most `length`, or never: it stops, or, per axis, passes k.
double time_of_braking_change(const RollingDeceleration& d, const Segment& ball,
                              const Braking& braking, double length);

// One more term of the ball's twist from the terms up to k, without contacts.
void extend_ball_twist(const RollingDeceleration& d, int k, Segment& ball, Braking& braking);

// The motion from `begin` (seconds of the tick) until the ball stops, the series ends, or
// `horizon`.
Segment roll(const RollingDeceleration& d, const BodyState& ball, double begin, double horizon);

}  // namespace mirocup::simulator::trajectory
