// SPDX-License-Identifier: MIT
#include "tests/support/exact_motion.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace mirocup::test_support {

namespace {

constexpr Real g = 9.81L;

struct Model {
  Real speed_reference = 0, turn_reference = 0, lateral_acceleration_limit = 0;
  Real forward_lag = 1, turn_lag = 1;
  bool wheels_on_ground = true;
  int slide = 0;  // sign of the sideways speed, 0: the wheels hold
};

ExactRobot derivative(const Model& m, const ExactRobot& s) {
  ExactRobot d;
  d.x = s.forward * std::cos(s.angle) - s.left * std::sin(s.angle);
  d.y = s.forward * std::sin(s.angle) + s.left * std::cos(s.angle);
  d.angle = s.turn;
  if (!m.wheels_on_ground) {
    d.forward = s.turn * s.left;
    d.left = -s.turn * s.forward;
    return d;
  }
  d.turn = (m.turn_reference - s.turn) / m.turn_lag;
  d.forward = (m.speed_reference - s.forward) / m.forward_lag + s.turn * s.left;
  d.left = m.slide == 0 ? 0 : -m.slide * m.lateral_acceleration_limit - s.turn * s.forward;
  return d;
}

// Returns s + h d.
ExactRobot plus(const ExactRobot& s, Real h, const ExactRobot& d) {
  return {s.x + h * d.x,       s.y + h * d.y,      s.angle + h * d.angle, s.forward + h * d.forward,
          s.left + h * d.left, s.turn + h * d.turn};
}

ExactRobot midpoint_rule(const Model& m, const ExactRobot& s, Real length, int steps) {
  const Real h = length / steps;
  ExactRobot before = s;
  ExactRobot now = plus(s, h, derivative(m, s));
  for (int i = 1; i < steps; ++i) {
    const ExactRobot next = plus(before, 2 * h, derivative(m, now));
    before = now;
    now = next;
  }
  return now;
}

// The midpoint rule with 2, 4, 6 ... steps, extrapolated to infinitely many steps: its error has
// only even powers of the step.
ExactRobot extrapolated(const Model& m, const ExactRobot& s, Real length) {
  constexpr int rows = 7;
  std::array<ExactRobot, rows> row;
  for (int j = 0; j < rows; ++j) {
    ExactRobot value = midpoint_rule(m, s, length, 2 * (j + 1));
    for (int k = 1; k <= j; ++k) {
      const Real ratio = static_cast<Real>(j + 1) / static_cast<Real>(j + 1 - k);
      const ExactRobot coarser = row[k - 1];
      row[k - 1] = value;
      const ExactRobot change = plus(value, -1, coarser);
      value = plus(value, 1 / (ratio * ratio - 1), change);
    }
    row[j] = value;
  }
  return row[rows - 1];
}

// Returns the share of the step after which `over` becomes true.
template <class Predicate>
Real bisect(const Model& m, const ExactRobot& s, Real length, Predicate over) {
  Real low = 0;
  Real high = length;
  for (int i = 0; i < 64; ++i) {
    const Real middle = (low + high) / 2;
    (over(extrapolated(m, s, middle)) ? high : low) = middle;
  }
  return high;
}

Model model_of(const simulator::Parameters& p, const simulator::WheelCommand& command) {
  Model m;
  m.wheels_on_ground = command.has_value();
  if (!command) return m;
  const Real limit = p.wheel_speed_limit;
  const Real left = std::clamp<Real>(command->left, -limit, limit);
  const Real right = std::clamp<Real>(command->right, -limit, limit);
  m.speed_reference = p.wheel_radius * (left + right) / 2;
  m.turn_reference = p.wheel_radius * (right - left) / p.wheel_distance;
  m.forward_lag = p.motor_time_constant;
  m.turn_lag = p.turn_time_constant > 0 ? p.turn_time_constant : p.motor_time_constant;
  const bool stops = left == 0 && right == 0;
  if (stops && p.brake_time_constant > 0) m.forward_lag = p.brake_time_constant;
  m.lateral_acceleration_limit = p.grip * g;
  return m;
}

}  // namespace

ExactRobot exactly(const simulator::BodyState& r) {
  return {r.position.x(),
          r.position.y(),
          std::atan2(static_cast<Real>(r.heading.sin), static_cast<Real>(r.heading.cos)),
          r.twist.forward,
          r.twist.left,
          r.twist.omega};
}

ExactBall exactly(const simulator::BallState& b) {
  return {b.position.x(), b.position.y(), b.velocity.x(), b.velocity.y()};
}

simulator::BodyState rounded(const ExactRobot& r) {
  const auto d = [](Real x) { return static_cast<double>(x); };
  return {{d(r.x), d(r.y)},
          {d(std::cos(r.angle)), d(std::sin(r.angle))},
          {d(r.forward), d(r.left), d(r.turn)}};
}

ExactRobot drive_exactly(const simulator::Parameters& p, ExactRobot s,
                         const simulator::WheelCommand& command, Real duration) {
  Model m = model_of(p, command);
  const bool can_slide = m.wheels_on_ground && p.grip != simulator::infinite_grip;
  // Steps are so short that wheels cannot both begin and cease to slide within one.
  const Real longest = can_slide ? 0.25e-3L : 1e-3L;
  if (!m.wheels_on_ground || can_slide) m.slide = (s.left > 0) - (s.left < 0);
  while (duration > 0) {
    const Real step = std::min(duration, longest);
    const auto too_hard = [&](const ExactRobot& r) {
      return can_slide && std::abs(r.turn * r.forward) > m.lateral_acceleration_limit;
    };
    if (can_slide && m.slide == 0 && too_hard(s)) m.slide = s.turn * s.forward > 0 ? -1 : 1;
    const auto has_changed = [&](const ExactRobot& r) {
      return m.slide == 0 ? too_hard(r) : can_slide && m.slide * r.left < 0;
    };
    const ExactRobot next = extrapolated(m, s, step);
    if (!has_changed(next)) {
      s = next;
      duration -= step;
      continue;
    }
    const Real until = bisect(m, s, step, has_changed);
    s = extrapolated(m, s, until);
    duration -= until;
    if (m.slide != 0) {
      s.left = 0;
      m.slide = 0;
    }
  }
  return s;
}

namespace {

struct Deceleration {
  Real constant, linear;
};

Deceleration deceleration(const simulator::Parameters& p) {
  const Real mass = 1.4L * p.ball_mass;
  return {p.rolling_resistance * p.ball_mass * g / mass, p.viscous_friction / mass};
}

// Distance and speed after t seconds, before the ball stops.
Real way(const Deceleration& d, Real speed, Real t) {
  if (d.linear == 0) return speed * t - d.constant * t * t / 2;
  const Real gone = -std::expm1(-d.linear * t) / d.linear;
  return (speed + d.constant / d.linear) * gone - d.constant / d.linear * t;
}

Real speed_after(const Deceleration& d, Real speed, Real t) {
  if (d.linear == 0) return speed - d.constant * t;
  return speed + (speed + d.constant / d.linear) * std::expm1(-d.linear * t);
}

Real stopping_time(const Deceleration& d, Real speed) {
  if (d.constant == 0) return HUGE_VALL;
  if (d.linear == 0) return speed / d.constant;
  return std::log1p(d.linear * speed / d.constant) / d.linear;
}

}  // namespace

ExactBall roll_exactly(const simulator::Parameters& p, ExactBall b, Real duration) {
  const Real speed = std::sqrt(b.vx * b.vx + b.vy * b.vy);
  if (speed == 0) return b;
  const Deceleration d = deceleration(p);
  const Real t = std::min(duration, stopping_time(d, speed));
  const Real ux = b.vx / speed;
  const Real uy = b.vy / speed;
  const Real along = way(d, speed, t);
  const Real left = t < duration ? 0 : std::max<Real>(0, speed_after(d, speed, t));
  return {b.x + ux * along, b.y + uy * along, ux * left, uy * left};
}

Real time_to_roll(const simulator::Parameters& p, Real speed, Real distance, Real limit) {
  const Deceleration d = deceleration(p);
  Real low = 0;
  Real high = std::min(limit, stopping_time(d, speed));
  if (way(d, speed, high) < distance) return 2 * limit;
  for (int i = 0; i < 100; ++i) {
    const Real middle = (low + high) / 2;
    (way(d, speed, middle) < distance ? low : high) = middle;
  }
  return high;
}

}  // namespace mirocup::test_support
