// SPDX-License-Identifier: MIT
#include "tests/physics/encounter.hpp"

#include <algorithm>
#include <cmath>

namespace mirocup::scenes {

using namespace test_support;

namespace {

// Velocity of the touching point along the normal.
double normal_speed(const MovingOutline& m, const TouchPoint& touch) {
  const Vec2& n = touch.normal;
  if (m.is_solid()) return 0.0;
  if (m.ball) {
    return static_cast<double>(m.ball->vx) * n.x() + static_cast<double>(m.ball->vy) * n.y();
  }
  const Vec2 f = m.forward();
  const Vec2 l{-f.y(), f.x()};
  const double turning = cross(Vec2{touch.point - m.position()}, n);
  return static_cast<double>(m.robot->forward) * f.dot(n) +
         static_cast<double>(m.robot->left) * l.dot(n) +
         static_cast<double>(m.robot->turn) * turning;
}

bool holds_sideways(const Parameters& p, const MovingOutline& m) {
  return m.robot && m.command && p.grip == simulator::infinite_grip;
}

}  // namespace

Outline MovingOutline::outline(const Parameters& p) const {
  const auto d = [](Real x) { return static_cast<double>(x); };
  if (robot)
    return test_support::square_at({d(robot->x), d(robot->y)}, d(robot->angle), p.robot_side);
  if (ball) return test_support::circle_at({d(ball->x), d(ball->y)}, p.ball_radius);
  return solid;
}

void MovingOutline::move(const Parameters& p, Real duration) {
  if (robot) robot = drive_exactly(p, *robot, command, duration);
  if (ball) ball = roll_exactly(p, *ball, duration);
}

double MovingOutline::speed_bound(const Parameters& p) const {
  if (ball) return static_cast<double>(std::hypot(ball->vx, ball->vy));
  if (!robot) return 0.0;
  const double fastest = p.wheel_radius * p.wheel_speed_limit;
  const double quickest = 2.0 * fastest / p.wheel_distance;
  const double speed = static_cast<double>(std::hypot(robot->forward, robot->left));
  const double turn = static_cast<double>(std::abs(robot->turn));
  return std::hypot(std::max(speed, fastest), speed) +
         std::max(turn, command ? quickest : 0.0) * p.robot_side;
}

double MovingOutline::mass(const Parameters& p) const {
  return robot ? p.robot_mass : 1.4 * p.ball_mass;
}

Vec2 MovingOutline::position() const {
  const auto d = [](Real x) { return static_cast<double>(x); };
  return robot ? Vec2{d(robot->x), d(robot->y)} : Vec2{d(ball->x), d(ball->y)};
}

Vec2 MovingOutline::forward() const {
  return {static_cast<double>(std::cos(robot->angle)), static_cast<double>(std::sin(robot->angle))};
}

double inertia(const Parameters& p) {
  return p.robot_mass * p.robot_side * p.robot_side / 6.0;
}

double inverse_mass(const Parameters& p, const MovingOutline& m, const TouchPoint& touch) {
  if (m.is_solid()) return 0.0;
  if (m.ball) return 1.0 / m.mass(p);
  const double lever = cross(Vec2{touch.point - m.position()}, touch.normal);
  const double along = holds_sideways(p, m) ? m.forward().dot(touch.normal) : 1.0;
  return along * along / p.robot_mass + lever * lever / inertia(p);
}

void push(const Parameters& p, MovingOutline& m, const TouchPoint& touch, double impulse) {
  if (m.is_solid()) return;
  const Vec2 change = impulse / m.mass(p) * touch.normal;
  if (m.ball) {
    m.ball->vx += change.x();
    m.ball->vy += change.y();
    return;
  }
  const Vec2 f = m.forward();
  m.robot->forward += change.dot(f);
  if (!holds_sideways(p, m)) m.robot->left += change.dot(Vec2{-f.y(), f.x()});
  m.robot->turn += impulse * cross(Vec2{touch.point - m.position()}, touch.normal) / inertia(p);
}

std::optional<Encounter> first_touch(const Parameters& p, MovingOutline& a, MovingOutline& b,
                                     Real limit) {
  constexpr double near = 1e-7;
  constexpr double too_slow = 0.05;
  Encounter e;
  const auto move = [&](Real by) {
    a.move(p, by);
    b.move(p, by);
    e.time += by;
  };
  double gap = distance(a.outline(p), b.outline(p));
  while (gap > near) {
    const double bound = a.speed_bound(p) + b.speed_bound(p);
    if (bound == 0.0) return {};
    move(0.999 * gap / bound);
    if (e.time > limit) return {};
    gap = distance(a.outline(p), b.outline(p));
  }
  const MovingOutline near_a = a;
  const MovingOutline near_b = b;
  Real after = 0;
  constexpr int newton_steps = 6;
  for (int i = 0; i < newton_steps; ++i) {
    const auto touches = test_support::touch_points(a.outline(p), b.outline(p), 2.0 * near);
    if (touches.size() != 1) return {};
    e.touch = touches[0];
    e.approach = normal_speed(b, e.touch) - normal_speed(a, e.touch);
    if (e.approach < too_slow) return {};
    if (i + 1 == newton_steps) break;
    after += e.touch.gap / e.approach;
    a = near_a;
    b = near_b;
    a.move(p, after);
    b.move(p, after);
  }
  e.time += after;
  return e;
}

}  // namespace mirocup::scenes
