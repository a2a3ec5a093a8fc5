// SPDX-License-Identifier: MIT
//
// Segments against the circle in closed form. Catches a recurrence with a wrong sign, and a length
// over which the series have not converged.
#include "core/simulator/trajectory/segment.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace mirocup::simulator::trajectory {
namespace {

const BodyState body{{0.2, -0.1}, Heading::from_angle(0.7), {0.8, -0.3, 9.0}};

// A body with a constant twist goes round a centre, at the lever J v / omega from it.
Vec2 position_on_circle(double t) {
  const Twist& v = body.twist;
  const Vec2 centre_in_body{-v.left / v.omega, v.forward / v.omega};
  const Vec2 centre = body.position + body.heading.to_world(centre_in_body);
  const double angle = 0.7 + v.omega * t;
  return centre - Heading::from_angle(angle).to_world(centre_in_body);
}

TEST(Segment, OfASteadyTwistIsACircle) {
  const Segment s = steady_segment(body, 0.004, 0.030);
  const double length = converged_length(s, s.end - s.begin, settings::segment.free_truncation);
  for (const double u : {0.0, 0.3 * length, length}) {
    const BodyState now = body_at(s, s.begin + u);
    EXPECT_NEAR((now.position - position_on_circle(u)).norm(), 0.0, 1e-12);
    EXPECT_NEAR(now.heading.cos, std::cos(0.7 + 9.0 * u), 1e-12);
    EXPECT_EQ(pose_at(s, s.begin + u).position, now.position);
    EXPECT_EQ(pose_at(s, s.begin + u).heading.sin, now.heading.sin);
    EXPECT_EQ(now.twist.left, body.twist.left);
  }
}

TEST(Segment, ArcInClosedFormIsTheSameCircle) {
  for (const double t : {0.0, 1e-6, 0.011, 0.2, 0.6}) {
    EXPECT_NEAR((along_arc(body, t).position - position_on_circle(t)).norm(), 0.0, 1e-13) << t;
  }
}

TEST(Segment, ConvergesOverTheLengthThatItSays) {
  const Segment s = steady_segment(body, 0.0, 1.0);
  const double length = converged_length(s, 1.0, settings::segment.free_truncation);
  EXPECT_LT(length, 1.0);
  EXPECT_TRUE(has_converged(s, length, settings::segment.free_truncation));
  EXPECT_FALSE(has_converged(s, length / 0.85, settings::segment.free_truncation));
}

TEST(Segment, SweptBoxAndTrackHoldTheCurve) {
  const Segment s = steady_segment(body, 0.0, 0.02);
  const Box box = swept_box(s);
  const Track track = track_from(s, 0.005);
  for (int i = 0; i <= 20; ++i) {
    const Vec2 p = body_at(s, 0.001 * i).position;
    EXPECT_TRUE(box.low_x <= p.x() && p.x() <= box.high_x);
    EXPECT_TRUE(box.low_y <= p.y() && p.y() <= box.high_y);
    if (i >= 5) {
      EXPECT_NEAR(track.x.at(0.001 * i - 0.005), p.x(), 1e-14);
    }
  }
}

}  // namespace
}  // namespace mirocup::simulator::trajectory
