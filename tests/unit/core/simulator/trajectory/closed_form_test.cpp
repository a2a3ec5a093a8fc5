// SPDX-License-Identifier: MIT
//
// The closed form against the integrator in extended precision. Catches a quadrature with a wrong
// weight, a robot that is let in although it slides, and a box or a bound that its path leaves; the
// bound also of the series of the same motion.
#include "core/simulator/trajectory/closed_form.hpp"

#include "core/base/random.hpp"
#include "tests/support/exact_motion.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace mirocup::simulator::trajectory {
namespace {

bool holds(const MotionBound& bound, const BodyState& robot, double t) {
  return (robot.position - bound.at(t)).norm() <= bound.max_deviation &&
         std::abs(robot.twist.omega) <= bound.max_omega * (1.0 + 1e-12);
}

TEST(ClosedForm, IsExactAndItsBoxAndBoundsHoldThePath) {
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
    const Segment series = drive(p, robot, reference, 0.0, decay.span, never);
    const MotionBound of_series = bound_of_segment(series);
    const MotionBound of_closed_form = closed_form_bound(robot, end, reference, decay, 0.0);
    for (int k = 0; k <= 10; ++k) {
      const double t = 0.0033 * k;
      const BodyState now = closed_form_state(robot, reference, t);
      ASSERT_TRUE(box.low_x <= now.position.x() && now.position.x() <= box.high_x) << i;
      ASSERT_TRUE(box.low_y <= now.position.y() && now.position.y() <= box.high_y) << i;
      ASSERT_TRUE(holds(of_closed_form, now, t)) << i;
      ASSERT_TRUE(t > series.end || holds(of_series, body_at(series, t), t)) << i;
    }
  }
  EXPECT_GT(checked, 50);
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
