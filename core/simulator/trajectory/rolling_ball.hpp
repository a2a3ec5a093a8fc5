// SPDX-License-Identifier: MIT
//
// The ball alone: it rolls without slipping and brakes along its own direction until it stops.
//
//   ds/dt = -(f_v s + K_c m g) / m',  m' = 7m/5        (6), (7), (8) with the paper's errata
//
// The speed s is one exponential, so the time at which it is zero is known in closed form. From
// then on the ball lies still.
//
// RollingFriction::per_axis is the paper's own form, for comparison: x and y brake separately (8),
// with a resistance that falls linearly below the speed k (9), so the ball never quite stops.
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
  // Returns the rate, 1/s, of an axis that is slower than k: dv/dt = -slow_rate() v.
  double slow_rate() const { return linear + constant / per_axis_below; }
};
// Returns the constants of a ball with these parameters.
RollingDeceleration rolling_deceleration(const Parameters& parameters);

// Returns the time, s, in which a ball of speed s >= 0 stops: ln(1 + linear s / constant) / linear,
// or `never`. For isotropic braking.
double stopping_time(const RollingDeceleration& d, double speed);

// The direction in which a ball in contact brakes, as series in the time of its segment. Below
// min_speed_with_direction (solver_settings.hpp) the direction is kept fixed.
struct Braking {
  bool is_fixed = false;
  // Isotropic: the unit vector of the motion. Per axis: the sign of each velocity component of at
  // least Rolling::per_axis_below, k, else 0.
  Series x, y;
  Series speed;                               // m/s; not used while the direction is fixed
  bool x_is_slow = false, y_is_slow = false;  // the ball's velocity along the axis is below k
};

// Returns the braking at the start of a segment. Its direction is that of `velocity`, m/s, if the
// ball moves, else that of `push`, a force in any unit, else zero.
Braking braking_along(const RollingDeceleration& d, const Vec2& velocity, const Vec2& push);

// Returns when the braking of a ball in contact changes, because the ball stops or, per axis, a
// component passes k: s since the start of its segment, or `never` if not within `length`, s.
double time_of_braking_change(const RollingDeceleration& d, const Segment& ball,
                              const Braking& braking, double length);

// Adds term k of `braking` and, from the terms up to k, term k + 1 of the ball's twist without
// contact forces.
void extend_ball_twist(const RollingDeceleration& d, int k, Segment& ball, Braking& braking);

// Returns the motion of a ball without contacts from `begin`, s of the tick. It ends at
// `horizon`, s of the tick, or before: where the ball stops, or where the series no longer
// converge.
Segment roll(const RollingDeceleration& d, const BodyState& ball, double begin, double horizon);

}  // namespace mirocup::simulator::trajectory
