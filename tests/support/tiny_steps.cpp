// SPDX-License-Identifier: MIT
#include "tests/support/tiny_steps.hpp"

#include <cmath>

namespace mirocup::test_support {

namespace {

constexpr double g = 9.81;

struct Model {
  double speed_reference, turn_reference, time_constant, sideways_limit;
  int slide = 0;  // sign of the sideways speed, 0: the wheels hold
};

RobotByAngle derivative(const Model& m, const RobotByAngle& s) {
  RobotByAngle d;
  d.x = s.forward * std::cos(s.angle) - s.left * std::sin(s.angle);
  d.y = s.forward * std::sin(s.angle) + s.left * std::cos(s.angle);
  d.angle = s.turn;
  d.turn = (m.turn_reference - s.turn) / m.time_constant;
  d.forward = (m.speed_reference - s.forward) / m.time_constant + s.turn * s.left;
  d.left = m.slide == 0 ? 0.0 : -m.slide * m.sideways_limit - s.turn * s.forward;
  return d;
}

RobotByAngle plus(const RobotByAngle& s, double h, const RobotByAngle& d) {
  return {s.x + h * d.x,       s.y + h * d.y,      s.angle + h * d.angle, s.forward + h * d.forward,
          s.left + h * d.left, s.turn + h * d.turn};
}

RobotByAngle runge_kutta(const Model& m, const RobotByAngle& s, double h) {
  const RobotByAngle k1 = derivative(m, s);
  const RobotByAngle k2 = derivative(m, plus(s, h / 2, k1));
  const RobotByAngle k3 = derivative(m, plus(s, h / 2, k2));
  const RobotByAngle k4 = derivative(m, plus(s, h, k3));
  RobotByAngle sum = plus(s, h / 6, k1);
  sum = plus(sum, h / 3, k2);
  sum = plus(sum, h / 3, k3);
  return plus(sum, h / 6, k4);
}

int sign(double v) {
  return v > 0.0 ? 1 : v < 0.0 ? -1 : 0;
}

// The share of the step after which `over` turns true.
template <class Predicate>
double bisect(const Model& m, const RobotByAngle& s, double h, Predicate over) {
  double low = 0.0;
  double high = h;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (over(runge_kutta(m, s, middle)) ? high : low) = middle;
  }
  return high;
}

}  // namespace

RobotByAngle drive_in_tiny_steps(const simulator::Parameters& p, RobotByAngle s, double left_wheel,
                                 double right_wheel, double duration, int steps) {
  Model m;
  m.speed_reference = p.wheel_radius * (left_wheel + right_wheel) / 2.0;
  m.turn_reference = p.wheel_radius * (right_wheel - left_wheel) / p.wheel_distance;
  m.time_constant = p.motor_time_constant;
  m.sideways_limit = p.grip * g;
  m.slide = sign(s.left);

  const double step = duration / steps;
  for (int i = 0; i < steps; ++i) {
    double left_over = step;
    while (left_over > 0.0) {
      const auto too_hard = [&](const RobotByAngle& r) {
        return std::abs(r.turn * r.forward) > m.sideways_limit;
      };
      if (m.slide == 0 && too_hard(s)) m.slide = -sign(s.turn * s.forward);
      const int slide = m.slide;
      const auto has_changed = [&](const RobotByAngle& r) {
        return slide == 0 ? too_hard(r) : slide * r.left < 0.0;
      };
      const RobotByAngle next = runge_kutta(m, s, left_over);
      if (!has_changed(next)) {
        s = next;
        break;
      }
      const double until = bisect(m, s, left_over, has_changed);
      s = runge_kutta(m, s, until);
      left_over -= until;
      if (slide != 0) {
        s.left = 0.0;
        m.slide = 0;
      }
      if (left_over < 1e-15) break;
    }
  }
  return s;
}

}  // namespace mirocup::test_support
