// SPDX-License-Identifier: MIT
#include "core/simulator/ball_motion.hpp"

#include <algorithm>
#include <cmath>

namespace mirocup::simulator {

RollingDeceleration rolling_deceleration(const Parameters& p) {
  const double mass = p.effective_ball_mass();
  return {.constant = p.rolling_resistance * p.ball_mass * gravity / mass,
          .linear = p.viscous_friction / mass};
}

double stopping_time(const RollingDeceleration& d, double speed) {
  if (speed == 0.0) return 0.0;
  if (d.constant == 0.0) return never;
  if (d.linear == 0.0) return speed / d.constant;
  return log1p(d.linear * speed / d.constant) / d.linear;
}

Braking braking_along(const Vec2& velocity, const Vec2& push) {
  Braking braking;
  double speed = std::sqrt(velocity.squaredNorm());
  if (speed <= no_rolling) speed = 0.0;
  braking.is_fixed = speed < slowest_own_direction;
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
    // speed^2 = v.v and direction * speed = v, term by term.
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
  ball.forward[k + 1] = -(d.linear * ball.forward[k] + d.constant * braking.x[k]) / (k + 1);
  ball.left[k + 1] = -(d.linear * ball.left[k] + d.constant * braking.y[k]) / (k + 1);
  ball.turn[k + 1] = 0.0;
}

Segment roll(const RollingDeceleration& d, const Body& ball, double begin, double horizon) {
  const Vec2 velocity{ball.twist.forward, ball.twist.left};
  const double speed = std::sqrt(velocity.squaredNorm());
  if (speed == 0.0) return still_segment(ball, begin, horizon);

  Segment s = still_segment(ball, begin, horizon);
  const double stops = begin + stopping_time(d, speed);
  s.end = std::min({horizon, stops, begin + segment_length(d.linear)});
  if (s.end == stops) s.settles = Settles::everything;

  // Along the direction of motion: derivatives of the speed, each -linear times the one before.
  Series along;
  along[0] = speed;
  along[1] = -(d.constant + d.linear * speed);
  for (int k = 1; k < series_terms - 1; ++k) along[k + 1] = -d.linear * along[k] / (k + 1);

  const double ux = velocity.x() / speed;
  const double uy = velocity.y() / speed;
  s.forward = ux * along;
  s.left = uy * along;
  for (int k = 0; k < series_terms - 1; ++k) {
    s.x[k + 1] = s.forward[k] / (k + 1);
    s.y[k + 1] = s.left[k] / (k + 1);
  }
  return s;
}

}  // namespace mirocup::simulator
