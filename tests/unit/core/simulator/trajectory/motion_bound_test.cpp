// SPDX-License-Identifier: MIT
//
// What a MotionBound rules out may never happen: curves of all kinds are sampled.
#include "core/simulator/trajectory/motion_bound.hpp"

#include "core/base/random.hpp"
#include "core/simulator/trajectory/closed_form.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace mirocup::simulator::trajectory {
namespace {

constexpr double tick = 0.033;

struct Moving {
  BodyState body;
  DriveReference drive;
  Segment segment;
  MotionBound way;
};

Moving random_robot(Random& random, bool as_series) {
  const Parameters p;
  Moving m;
  m.body.position = {random.uniform(-0.12, 0.12), random.uniform(-0.12, 0.12)};
  m.body.heading = Heading::from_angle(random.uniform(-pi, pi));
  m.body.twist = {random.uniform(-0.9, 0.9), 0.0, random.uniform(-7.0, 7.0)};
  m.drive =
      drive_reference(p, WheelSpeeds{random.uniform(-40.0, 40.0), random.uniform(-40.0, 40.0)});
  m.segment = drive(p, m.body, m.drive, 0.0, tick, never);
  if (as_series) {
    m.way = bound_of_segment(m.segment);
  } else {
    const MotorDecay decay = motor_decay(p.motor_time_constant, tick);
    m.way = closed_form_bound(m.body, closed_form_state(m.body, m.drive, {decay, decay}), m.drive,
                              decay, 0.0);
  }
  return m;
}

TEST(MotionBound, HoldsTheCurveAndItsTurning) {
  Random random(11);
  for (int i = 0; i < 400; ++i) {
    const Moving m = random_robot(random, i % 2 == 0);
    for (int k = 0; k <= 50; ++k) {
      const double t = m.segment.end * k / 50.0;
      const BodyState now = body_at(m.segment, t);
      ASSERT_LE((now.position - m.way.at(t)).norm(), m.way.max_deviation) << i;
      ASSERT_LE(std::abs(now.twist.omega), m.way.max_omega * (1.0 + 1e-12)) << i;
    }
  }
}

}  // namespace
}  // namespace mirocup::simulator::trajectory
