// SPDX-License-Identifier: MIT
#include "core/simulator/trajectory/differential_drive.hpp"

#include <algorithm>
#include <cmath>

namespace mirocup::simulator {

namespace {

// p(t) / t for a series that starts at zero.
Series divided_by_time(const Series& p) {
  Series q;
  q.terms = p.terms;
  for (int k = 1; k < series_terms; ++k) q[k - 1] = p[k];
  return q;
}

// When rolling wheels lose their grip: |omega v_f| rises above the limit.
double slide_begins(const Parameters& p, const Segment& s, const Drive& drive) {
  if (p.grip == infinite_grip) return never;
  const double limit = sideways_limit(p);
  // Both speeds go monotonically from where they are to where the motors aim.
  const double fastest = std::max(std::abs(s.forward[0]), std::abs(drive.forward));
  const double quickest = std::max(std::abs(s.turn[0]), std::abs(drive.turn));
  if (fastest * quickest <= limit) return never;
  const Series sideways = s.turn * s.forward;
  const double length = s.end - s.begin;
  return std::min(first_fall(sideways, -limit, 0.0, length),
                  first_fall(-1.0 * sideways, -limit, 0.0, length));
}

}  // namespace

Drive drive_of(const Parameters& p, const WheelCommand& command) {
  if (!command) return {.wheels_on_ground = false};
  const double limit = p.wheel_speed_limit;
  const double left = std::clamp(command->left, -limit, limit);
  const double right = std::clamp(command->right, -limit, limit);
  return {.forward = p.forward_speed(left, right), .turn = p.turn_rate(left, right)};
}

Wheels wheels_of(const Parameters& p, const BodyState& robot, const Drive& drive) {
  if (!drive.wheels_on_ground) return Wheels::lifted;
  if (p.grip == infinite_grip) return Wheels::rolling;
  const Twist& v = robot.twist;
  // Half the margin of sideways_limit(): a slide that began at the limit is seen to have begun.
  const bool turns_too_hard =
      std::abs(v.turn * v.forward) > p.grip * gravity * (1.0 + 0.5 * grip_margin);
  return std::abs(v.left) > no_sliding || turns_too_hard ? Wheels::sliding : Wheels::rolling;
}

void extend_twist_on_ground(const Parameters& p, const Drive& drive, double slide, int k,
                            Segment& s) {
  const double rate = 1.0 / p.motor_time_constant;
  const double next = k + 1;
  const double aim = k == 0 ? 1.0 : 0.0;
  s.turn[k + 1] = rate * (aim * drive.turn - s.turn[k]) / next;
  s.forward[k + 1] = rate * (aim * drive.forward - s.forward[k]) / next;
  if (slide == 0.0) return;
  s.forward[k + 1] += product_term(s.turn, s.left, k) / next;
  s.left[k + 1] = (-aim * slide * p.grip * gravity - product_term(s.turn, s.forward, k)) / next;
}

void extend_twist_lifted(int k, Segment& s) {
  s.forward[k + 1] = product_term(s.turn, s.left, k) / (k + 1);
  s.left[k + 1] = -product_term(s.turn, s.forward, k) / (k + 1);
  s.turn[k + 1] = 0.0;
}

double slide_ends(const Segment& s, double slide) {
  const Series sideways = slide * (s.left[0] == 0.0 ? divided_by_time(s.left) : s.left);
  return first_fall(sideways, 0.0, 0.0, s.end - s.begin);
}

Segment drive(const Parameters& p, const BodyState& robot, const Drive& drive, double begin,
              double horizon, double enough) {
  const Wheels wheels = wheels_of(p, robot, drive);
  const double quickest = std::max(std::abs(robot.twist.turn), std::abs(drive.turn));
  const double rate = wheels == Wheels::lifted ? quickest : quickest + 1.0 / p.motor_time_constant;
  double slide = 0.0;
  if (wheels == Wheels::sliding) {
    const bool starts = std::abs(robot.twist.left) <= no_sliding;
    const double towards = starts ? -robot.twist.turn * robot.twist.forward : robot.twist.left;
    slide = towards > 0.0 ? 1.0 : -1.0;
  }

  Segment s = moving_segment(robot, begin, std::min(horizon, begin + segment_length(rate)));
  if (wheels != Wheels::lifted && std::abs(s.left[0]) <= no_sliding) s.left[0] = 0.0;
  fill_series(s, enough, [&](int k) {
    if (wheels == Wheels::lifted) {
      extend_twist_lifted(k, s);
    } else {
      extend_twist_on_ground(p, drive, slide, k, s);
    }
    integrate_pose(s, k, wheels != Wheels::rolling);
  });

  if (wheels == Wheels::rolling) s.end = std::min(s.end, begin + slide_begins(p, s, drive));
  if (wheels == Wheels::sliding) {
    const double ends = begin + slide_ends(s, slide);
    if (ends <= s.end) {
      s.end = ends;
      s.settles = Settles::sideways;
    }
  }
  return s;
}

}  // namespace mirocup::simulator
