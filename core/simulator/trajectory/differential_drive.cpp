// SPDX-License-Identifier: MIT
#include "core/simulator/trajectory/differential_drive.hpp"

#include <algorithm>
#include <cmath>

namespace mirocup::simulator::trajectory {

namespace {

// Returns p(t) / t for a series that starts at zero.
Series divided_by_time(const Series& p) {
  Series q;
  q.terms = p.terms;
  for (int k = 1; k < max_terms; ++k) q[k - 1] = p[k];
  return q;
}

// Returns the time since the start of s at which rolling wheels lose their grip, because |omega
// v_f| exceeds the limit, or `never`.
double time_of_slip(const Parameters& p, const Segment& s, const DriveReference& drive) {
  if (p.grip == infinite_grip) return never;
  const double limit = lateral_acceleration_limit(p);
  // Both speeds go monotonically from their values now to those of the drive reference, so each is
  // fastest at one of the two.
  const double fastest = std::max(std::abs(s.forward[0]), std::abs(drive.forward));
  const double quickest = std::max(std::abs(s.omega[0]), std::abs(drive.omega));
  if (fastest * quickest <= limit) return never;
  const Series sideways = s.omega * s.forward;
  const double length = s.end - s.begin;
  return std::min(first_crossing(sideways, -limit, 0.0, length),
                  first_crossing(-1.0 * sideways, -limit, 0.0, length));
}

double at_least(double lag) {
  return std::max(lag, settings::differential_drive.least_lag);
}

}  // namespace

DriveReference drive_reference(const Parameters& p, const WheelCommand& command) {
  if (!command) return {.wheels_on_ground = false};
  const double limit = p.wheel_speed_limit;
  const double left = std::clamp(command->left, -limit, limit);
  const double right = std::clamp(command->right, -limit, limit);
  const bool brakes = p.brake_time_constant > 0.0 && left == 0.0 && right == 0.0;
  return {.forward = p.speed_reference(left, right),
          .omega = p.omega_reference(left, right),
          .forward_lag = at_least(brakes ? p.brake_time_constant : p.motor_time_constant),
          .turn_lag = at_least(p.turn_lag())};
}

WheelState wheel_state(const Parameters& p, const BodyState& robot, const DriveReference& drive) {
  if (!drive.wheels_on_ground) return WheelState::lifted;
  if (p.grip == infinite_grip) return WheelState::rolling;
  const Twist& v = robot.twist;
  // Half the margin of lateral_acceleration_limit(), so that a robot at whose limit a segment has
  // ended is found to slide.
  const bool turns_too_hard =
      std::abs(v.omega * v.forward) >
      p.grip * gravity * (1.0 + 0.5 * settings::differential_drive.grip_margin);
  return std::abs(v.left) > settings::differential_drive.slip_round_off || turns_too_hard
             ? WheelState::sliding
             : WheelState::rolling;
}

void extend_twist_on_ground(const Parameters& p, const DriveReference& drive, double slide, int k,
                            Segment& s) {
  const double omega_rate = 1.0 / drive.turn_lag;
  const double forward_rate = 1.0 / drive.forward_lag;
  const double next = k + 1;
  const double aim = k == 0 ? 1.0 : 0.0;
  s.omega[k + 1] = omega_rate * (aim * drive.omega - s.omega[k]) / next;
  s.forward[k + 1] = forward_rate * (aim * drive.forward - s.forward[k]) / next;
  if (slide == 0.0) return;
  double turned_left = 0.0;
  double turned_forward = 0.0;
  for (int j = 0; j <= k; ++j) {
    turned_left += s.omega[j] * s.left[k - j];
    turned_forward += s.omega[j] * s.forward[k - j];
  }
  s.forward[k + 1] += turned_left / next;
  s.left[k + 1] = (-aim * slide * p.grip * gravity - turned_forward) / next;
}

void extend_twist_lifted(int k, Segment& s) {
  s.forward[k + 1] = product_term(s.omega, s.left, k) / (k + 1);
  s.left[k + 1] = -product_term(s.omega, s.forward, k) / (k + 1);
  s.omega[k + 1] = 0.0;
}

double time_of_grip(const Segment& s, double slide) {
  // A slide that begins has v_l = 0 at the start. Divided by t, that root is left out.
  const Series sideways = slide * (s.left[0] == 0.0 ? divided_by_time(s.left) : s.left);
  return first_crossing(sideways, 0.0, 0.0, s.end - s.begin);
}

Segment drive(const Parameters& p, const BodyState& robot, const DriveReference& drive,
              double begin, double horizon, double preferred_duration) {
  const WheelState wheels = wheel_state(p, robot, drive);
  const double quickest = std::max(std::abs(robot.twist.omega), std::abs(drive.omega));
  const double rate = wheels == WheelState::lifted ? quickest : quickest + drive.rate();
  double slide = 0.0;
  if (wheels == WheelState::sliding) {
    const bool starts = std::abs(robot.twist.left) <= settings::differential_drive.slip_round_off;
    const double towards = starts ? -robot.twist.omega * robot.twist.forward : robot.twist.left;
    slide = towards > 0.0 ? 1.0 : -1.0;
  }

  Segment s = moving_segment(robot, begin, std::min(horizon, begin + segment_length(rate)));
  if (wheels != WheelState::lifted &&
      std::abs(s.left[0]) <= settings::differential_drive.slip_round_off)
    s.left[0] = 0.0;
  fill_series(s, preferred_duration, [&](int k) {
    if (wheels == WheelState::lifted) {
      extend_twist_lifted(k, s);
    } else {
      extend_twist_on_ground(p, drive, slide, k, s);
    }
    integrate_pose(s, k, wheels != WheelState::rolling);
  });

  if (wheels == WheelState::rolling) s.end = std::min(s.end, begin + time_of_slip(p, s, drive));
  if (wheels == WheelState::sliding) {
    const double ends = begin + time_of_grip(s, slide);
    if (ends <= s.end) {
      s.end = ends;
      s.settles = TerminalState::sideways;
    }
  }
  return s;
}

}  // namespace mirocup::simulator::trajectory
