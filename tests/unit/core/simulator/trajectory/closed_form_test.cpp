// SPDX-License-Identifier: MIT
//
// The closed form against the integrator in extended precision. Catches a quadrature with a wrong
// weight, a robot that is let in although it slides, and a box that its path leaves.
#include "core/simulator/trajectory/closed_form.hpp"

#include "core/base/random.hpp"
#include "tests/support/exact_motion.hpp"

#include <gtest/gtest.h>

namespace mirocup::simulator::trajectory {
namespace {

TEST(ClosedForm, IsExactAndItsBoxHoldsThePath) {
  const Parameters p;
  const MotorDecay decay = motor_decay(p, 0.033);
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
    const BodyState end = closed_form_state(robot, reference, decay);
    const BodyState exact = test_support::rounded(
        test_support::drive_exactly(p, test_support::exactly(robot), command, 0.033L));
    ASSERT_NEAR((end.position - exact.position).norm(), 0.0, 1e-14) << i;
    ASSERT_NEAR(end.heading.cos, exact.heading.cos, 1e-14) << i;
    ASSERT_NEAR(end.twist.omega, exact.twist.omega, 1e-13) << i;
    const Box box = closed_form_box(robot, end, reference, decay);
    for (int k = 0; k <= 10; ++k) {
      const double t = 0.0033 * k;
      const Vec2 now = closed_form_state(robot, reference, motor_decay(p, t)).position;
      ASSERT_TRUE(box.low_x <= now.x() && now.x() <= box.high_x) << i;
      ASSERT_TRUE(box.low_y <= now.y() && now.y() <= box.high_y) << i;
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
