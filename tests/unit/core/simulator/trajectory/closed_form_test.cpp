// SPDX-License-Identifier: MIT
//
// The closed form against the integrator in extended precision. Catches a quadrature with a wrong
// weight, a robot that is let in although it slides, and a box that its path leaves.
#include "core/simulator/trajectory/closed_form.hpp"

#include "core/base/random.hpp"
#include "tests/support/exact_motion.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace mirocup::simulator::trajectory {
namespace {

TEST(ClosedForm, IsExactAndItsBoxHoldsThePath) {
  const Parameters p;
  const MotorDecay decay = motor_decay(p.motor_time_constant, 0.033);
  Random random(1);
  int checked = 0;
  for (int i = 0; i < 200; ++i) {
    const BodyState robot{{random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0)},
                          Heading::from_angle(random.uniform(-pi, pi)),
                          {random.uniform(-1.0, 1.0), 0.0, random.uniform(-6.0, 6.0)}};
    const WheelSpeeds command{random.uniform(-50.0, 50.0), random.uniform(-50.0, 50.0)};
    const DriveReference reference = drive_reference(p, command);
    if (!has_closed_form(p, robot, reference, decay.span)) continue;
    ++checked;
    const BodyState end = closed_form_state(robot, reference, {decay, decay});
    const BodyState exact = test_support::rounded(
        test_support::drive_exactly(p, test_support::exactly(robot), command, 0.033L));
    ASSERT_NEAR((end.position - exact.position).norm(), 0.0, 1e-14) << i;
    ASSERT_NEAR(end.heading.cos, exact.heading.cos, 1e-14) << i;
    ASSERT_NEAR(end.twist.omega, exact.twist.omega, 1e-13) << i;
    const Box box = closed_form_box(robot, end, reference, decay);
    for (int k = 0; k <= 10; ++k) {
      const double t = 0.0033 * k;
      const Vec2 now = closed_form_state(robot, reference, t).position;
      ASSERT_TRUE(box.low_x <= now.x() && now.x() <= box.high_x) << i;
      ASSERT_TRUE(box.low_y <= now.y() && now.y() <= box.high_y) << i;
    }
  }
  EXPECT_GT(checked, 50);
}

// Returns the robot after t seconds of the closed solution, its path summed up in small pieces:
// v = v_ref + (v_0 - v_ref) e^(-t/T_f), the turn rate likewise with T_w, the heading its integral.
BodyState after_two_lags(const BodyState& robot, const DriveReference& d, double t) {
  const auto decayed = [](double now, double aim, double lag, double at) {
    return aim + (now - aim) * std::exp(-at / lag);
  };
  const auto turned = [&](double at) {
    return d.omega * at +
           (robot.twist.omega - d.omega) * d.turn_lag * -std::expm1(-at / d.turn_lag);
  };
  constexpr int pieces = 2000;  // Simpson's rule: far below 1e-14
  Vec2 path{0.0, 0.0};
  for (int i = 0; i <= 2 * pieces; ++i) {
    const double at = t * i / (2.0 * pieces);
    const double weight = i == 0 || i == 2 * pieces ? 1.0 : i % 2 == 1 ? 4.0 : 2.0;
    const double v = decayed(robot.twist.forward, d.forward, d.forward_lag, at);
    path += weight * v * Vec2{std::cos(turned(at)), std::sin(turned(at))};
  }
  BodyState end = robot;
  end.position += robot.heading.to_world(path * (t / (6.0 * pieces)));
  end.heading = robot.heading.turned(sincos(turned(t)));
  end.twist = {decayed(robot.twist.forward, d.forward, d.forward_lag, t), 0.0,
               decayed(robot.twist.omega, d.omega, d.turn_lag, t)};
  return end;
}

// Catches two lags that are mixed up, in the closed form or in the series, and a brake that acts on
// other commands than (0, 0), on the turn rate, or not at all.
TEST(ClosedForm, MotorsWithTwoLagsAndABrake) {
  Parameters p;
  p.grip = infinite_grip;
  p.motor_time_constant = 0.269;
  p.turn_time_constant = 0.052;
  p.brake_time_constant = 0.0145;
  const BodyState robot{{0.1, -0.2}, Heading::from_angle(0.7), {0.8, 0.0, 3.0}};
  constexpr double tick = 1.0 / 60.0;
  for (const WheelSpeeds command :
       {WheelSpeeds{40.0, 25.0}, WheelSpeeds{0.0, 0.0}, WheelSpeeds{0.0, 1e-3}}) {
    const DriveReference reference = drive_reference(p, command);
    const bool stands = command.left == 0.0 && command.right == 0.0;
    EXPECT_EQ(reference.forward_lag, stands ? 0.0145 : 0.269);
    EXPECT_EQ(reference.turn_lag, 0.052);
    const BodyState exact = after_two_lags(robot, reference, tick);
    ASSERT_TRUE(has_closed_form(p, robot, reference, tick));
    BodyState in_series = robot;
    for (double t = 0.0; t < tick;) {
      const Segment segment = drive(p, in_series, reference, t, tick, never);
      in_series = body_at(segment, segment.end);
      t = segment.end;
    }
    const BodyState closed = closed_form_state(robot, reference, tick);
    EXPECT_NEAR((closed.position - exact.position).norm(), 0.0, 1e-14);
    EXPECT_NEAR(closed.heading.sin, exact.heading.sin, 1e-14);
    EXPECT_NEAR(closed.twist.forward, exact.twist.forward, 1e-14);
    EXPECT_NEAR(closed.twist.omega, exact.twist.omega, 1e-13);
    EXPECT_NEAR((in_series.position - exact.position).norm(), 0.0, 1e-10);
    EXPECT_NEAR(in_series.twist.forward, exact.twist.forward, 1e-9);
  }
}

TEST(ClosedForm, IsRefusedWhereTheWheelsSlideOrAreLifted) {
  const Parameters p;
  const DriveReference reference = drive_reference(p, WheelSpeeds{10.0, 10.0});
  EXPECT_TRUE(has_closed_form(p, {{0.0, 0.0}, Heading{}, {0.3, 0.0, 1.0}}, reference, 0.033));
  EXPECT_FALSE(has_closed_form(p, {{0.0, 0.0}, Heading{}, {0.3, 0.01, 1.0}}, reference, 0.033));
  EXPECT_FALSE(has_closed_form(p, {{0.0, 0.0}, Heading{}, {2.0, 0.0, 6.0}}, reference, 0.033));
  EXPECT_FALSE(has_closed_form(p, {{0.0, 0.0}, Heading{}, {0.3, 0.0, 1.0}},
                               drive_reference(p, WheelCommand{}), 0.033));
}

}  // namespace
}  // namespace mirocup::simulator::trajectory
