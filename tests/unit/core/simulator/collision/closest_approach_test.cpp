// SPDX-License-Identifier: MIT
//
// A pair that a bound rules out must never touch: trajectories of robots are sampled.
#include "core/simulator/collision/closest_approach.hpp"

#include "core/base/random.hpp"
#include "core/simulator/trajectory/closed_form.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace mirocup::simulator::collision {
namespace {

constexpr double tick = 0.033;

struct Moving {
  BodyState body;
  trajectory::Segment segment;
  trajectory::MotionBound bound;
};

Moving random_robot(Random& random, bool as_series) {
  const Parameters p;
  Moving m;
  m.body.position = {random.uniform(-0.12, 0.12), random.uniform(-0.12, 0.12)};
  m.body.heading = Heading::from_angle(random.uniform(-pi, pi));
  m.body.twist = {random.uniform(-0.9, 0.9), 0.0, random.uniform(-7.0, 7.0)};
  const trajectory::DriveReference drive = trajectory::drive_reference(
      p, WheelSpeeds{random.uniform(-40.0, 40.0), random.uniform(-40.0, 40.0)});
  m.segment = trajectory::drive(p, m.body, drive, 0.0, tick, trajectory::never);
  if (as_series) {
    m.bound = trajectory::bound_of_segment(m.segment);
  } else {
    const trajectory::MotorDecay decay = trajectory::motor_decay(p.motor_time_constant, tick);
    m.bound = trajectory::closed_form_bound(
        m.body, trajectory::closed_form_state(m.body, drive, {decay, decay}), drive, decay, 0.0);
  }
  return m;
}

// Catches a bound that forgets the deviation from the chord, or that outlines turn.
TEST(ClosestApproach, NeverRulesOutAContact) {
  const geometry::Outline shape = robot_outline(Parameters{});
  constexpr double margin = 1e-10;
  Random random(12);
  int out_of_reach = 0;
  int never_touches = 0;
  int touches = 0;
  for (int i = 0; i < 4000; ++i) {
    const Moving a = random_robot(random, i % 2 == 0);
    const Moving b = random_robot(random, i % 3 == 0);
    const geometry::Separation at_start = separation(shape, a.body, shape, b.body);
    if (at_start.gap <= margin) continue;
    const double end = std::min(a.segment.end, b.segment.end);
    const ApproachQuery query{a.bound, b.bound, 2.0 * shape.radius + margin, 0.0, end};
    const bool apart = stays_out_of_reach(query);
    const double earliest =
        earliest_contact_time(query, at_start, shape.radius, shape.radius, margin);
    out_of_reach += apart;
    never_touches += earliest == trajectory::never;
    for (int k = 0; k <= 100; ++k) {
      const double t = end * k / 100.0;
      if (gap(shape, pose_at(a.segment, t), shape, pose_at(b.segment, t)) > margin) continue;
      ++touches;
      ASSERT_FALSE(apart) << i;
      ASSERT_LE(earliest, t) << i;
      break;
    }
  }
  // It would be easy to rule out nothing.
  EXPECT_GT(out_of_reach, 500);
  EXPECT_GT(never_touches, 1500);
  EXPECT_GT(touches, 50);
}

// Catches a bound that is needlessly early: without deviation and turning it is the exact time.
TEST(ClosestApproach, IsExactForStraightMotion) {
  const geometry::Outline shape = geometry::square(0.08);
  const BodyState a{{0.0, 0.0}, Heading{}, {}};
  const BodyState b{{0.1, 0.0}, Heading{}, {}};
  ApproachQuery query{{}, {}, 2.0 * shape.radius, 0.0, tick};
  query.b.from = b.position;
  query.b.velocity = {-1.0, 0.0};
  const geometry::Separation now = separation(shape, a, shape, b);
  EXPECT_FALSE(stays_out_of_reach(query));
  EXPECT_NEAR(earliest_contact_time(query, now, shape.radius, shape.radius, 0.0), 0.02, 1e-12);
  query.end = 0.019;
  EXPECT_EQ(earliest_contact_time(query, now, shape.radius, shape.radius, 0.0), trajectory::never);
  query.b.velocity = {1.0, 0.0};
  EXPECT_EQ(earliest_contact_time(query, now, shape.radius, shape.radius, 0.0), trajectory::never);
}

}  // namespace
}  // namespace mirocup::simulator::collision
