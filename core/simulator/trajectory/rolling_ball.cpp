// SPDX-License-Identifier: MIT
#include "core/simulator/trajectory/rolling_ball.hpp"

#include <algorithm>
#include <cmath>

namespace mirocup::simulator::trajectory {

namespace {

bool is_slow(const RollingDeceleration& d, double component) {
  return std::abs(component) <= d.per_axis_below * (1.0 + settings::rolling_ball.k_margin);
}

Segment roll_per_axis(const RollingDeceleration& d, const BodyState& ball, double begin,
                      double horizon) {
  const Vec2 velocity{ball.twist.forward, ball.twist.left};
  if (velocity.squaredNorm() <=
      settings::rolling_ball.roll_round_off * settings::rolling_ball.roll_round_off) {
    return still_segment(ball, begin, horizon);
  }
  Braking braking = braking_along(d, velocity, Vec2{0.0, 0.0});
  double end = horizon;
  double rate = d.linear;
  for (int axis = 0; axis < 2; ++axis) {
    const double speed = std::abs(axis == 0 ? velocity.x() : velocity.y());
    if (axis == 0 ? braking.x_is_slow : braking.y_is_slow) {
      rate = d.slow_rate();
    } else {
      // The time in which the component slows down to k is that in which a ball stops whose
      // constant deceleration is the one at k.
      const double at_k = d.constant + d.linear * d.per_axis_below;
      end = std::min(end, begin + stopping_time({.constant = at_k, .linear = d.linear},
                                                speed - d.per_axis_below));
    }
  }
  Segment s = moving_segment(ball, begin, std::min(end, begin + segment_length(rate)));
  fill_series(s, never, [&](int k) {
    integrate_pose(s, k);
    extend_ball_twist(d, k, s, braking);
  });
  return s;
}

}  // namespace

RollingDeceleration rolling_deceleration(const Parameters& p) {
  const double mass = p.effective_ball_mass();
  return {.constant = p.rolling_resistance * p.ball_mass * gravity / mass,
          .linear = p.viscous_friction / mass,
          .per_axis_below = p.rolling_friction == RollingFriction::per_axis ? p.k : 0.0};
}

double stopping_time(const RollingDeceleration& d, double speed) {
  if (speed == 0.0) return 0.0;
  if (d.constant == 0.0) return never;
  if (d.linear == 0.0) return speed / d.constant;
  return log1p(d.linear * speed / d.constant) / d.linear;
}

Braking braking_along(const RollingDeceleration& d, const Vec2& velocity, const Vec2& push) {
  Braking braking;
  if (d.is_per_axis()) {
    braking.is_fixed = true;
    braking.x_is_slow = is_slow(d, velocity.x());
    braking.y_is_slow = is_slow(d, velocity.y());
    if (!braking.x_is_slow) braking.x[0] = velocity.x() > 0.0 ? 1.0 : -1.0;
    if (!braking.y_is_slow) braking.y[0] = velocity.y() > 0.0 ? 1.0 : -1.0;
    return braking;
  }
  double speed = std::sqrt(velocity.squaredNorm());
  if (speed <= settings::rolling_ball.roll_round_off) speed = 0.0;
  braking.is_fixed = speed < settings::rolling_ball.min_speed_with_direction;
  const double force = std::sqrt(push.squaredNorm());
  Vec2 direction{0.0, 0.0};
  if (speed > 0.0) {
    direction = velocity / speed;
  } else if (force > 0.0) {
    direction = push / force;
  }
  braking.speed[0] = speed;
  braking.x[0] = direction.x();
  braking.y[0] = direction.y();
  return braking;
}

void extend_ball_twist(const RollingDeceleration& d, int k, Segment& ball, Braking& braking) {
  if (!braking.is_fixed && k > 0) {
    // Term k of speed^2 = v.v, solved for the speed, and of direction * speed = v, solved for the
    // direction.
    double square =
        product_term(ball.forward, ball.forward, k) + product_term(ball.left, ball.left, k);
    for (int j = 1; j < k; ++j) square -= braking.speed[j] * braking.speed[k - j];
    braking.speed[k] = square / (2.0 * braking.speed[0]);
    double x = ball.forward[k];
    double y = ball.left[k];
    for (int j = 0; j < k; ++j) {
      x -= braking.x[j] * braking.speed[k - j];
      y -= braking.y[j] * braking.speed[k - j];
    }
    braking.x[k] = x / braking.speed[0];
    braking.y[k] = y / braking.speed[0];
  }
  const double rate_x = braking.x_is_slow ? d.slow_rate() : d.linear;
  const double rate_y = braking.y_is_slow ? d.slow_rate() : d.linear;
  ball.forward[k + 1] = -(rate_x * ball.forward[k] + d.constant * braking.x[k]) / (k + 1);
  ball.left[k + 1] = -(rate_y * ball.left[k] + d.constant * braking.y[k]) / (k + 1);
  ball.omega[k + 1] = 0.0;
}

double time_of_braking_change(const RollingDeceleration& d, const Segment& ball,
                              const Braking& braking, double length) {
  if (!d.is_per_axis()) {
    if (braking.speed[0] <= 0.0) return never;
    const Series along = braking.x[0] * ball.forward + braking.y[0] * ball.left;
    return first_crossing(along, 0.0, 0.0, length);
  }
  const auto passes = [&](const Series& v, bool slow, double sign) {
    if (!slow) return first_crossing(sign * v, d.per_axis_below, 0.0, length);
    const double above = d.per_axis_below * (1.0 + 2.0 * settings::rolling_ball.k_margin);
    return std::min(first_crossing(v, -above, 0.0, length),
                    first_crossing(-1.0 * v, -above, 0.0, length));
  };
  return std::min(passes(ball.forward, braking.x_is_slow, braking.x[0]),
                  passes(ball.left, braking.y_is_slow, braking.y[0]));
}

Segment roll(const RollingDeceleration& d, const BodyState& ball, double begin, double horizon) {
  if (d.is_per_axis()) return roll_per_axis(d, ball, begin, horizon);
  const Vec2 velocity{ball.twist.forward, ball.twist.left};
  const double speed = std::sqrt(velocity.squaredNorm());
  if (speed <= settings::rolling_ball.roll_round_off) return still_segment(ball, begin, horizon);

  Segment s = still_segment(ball, begin, horizon);
  const double stops = begin + stopping_time(d, speed);
  s.end = std::min({horizon, stops, begin + segment_length(d.linear)});

  // The direction stays. The coefficients of the speed follow from ds/dt = -constant - linear s.
  const double ux = velocity.x() / speed;
  const double uy = velocity.y() / speed;
  double along = speed;
  s.forward[0] = ux * along;
  s.left[0] = uy * along;
  fill_series(s, never, [&](int k) {
    s.x[k + 1] = s.forward[k] / (k + 1);
    s.y[k + 1] = s.left[k] / (k + 1);
    along = -((k == 0 ? d.constant : 0.0) + d.linear * along) / (k + 1);
    s.forward[k + 1] = ux * along;
    s.left[k + 1] = uy * along;
  });
  if (s.end == stops) s.settles = TerminalState::everything;
  return s;
}

}  // namespace mirocup::simulator::trajectory
