// SPDX-License-Identifier: MIT
//
// Catches a search that does not look at some corner, or takes a body for where it is not.
#include "core/simulator/collision/time_of_impact.hpp"

#include "core/base/math.hpp"

#include <gtest/gtest.h>

#include <array>

namespace mirocup::simulator::collision {
namespace {

constexpr double whole_tick = 0.033;

geometry::Outline regular_polygon(int corners, double radius) {
  std::array<Vec2, geometry::max_corners> corner;
  for (int i = 0; i < corners; ++i) {
    const Heading to = Heading::from_angle(2.0 * pi * i / corners);
    corner[i] = {radius * to.cos, radius * to.sin};
  }
  return geometry::polygon({corner.data(), static_cast<std::size_t>(corners)});
}

TEST(FirstTouch, IsThatOfWhicheverCornerLeads) {
  const geometry::Outline cube = geometry::square(0.08);
  const trajectory::Segment still = trajectory::still_segment(BodyState{}, 0.0, whole_tick);
  for (int corners = 3; corners <= geometry::max_corners; ++corners) {
    const geometry::Outline shape = regular_polygon(corners, 0.05);
    for (int leading = 0; leading < corners; ++leading) {
      // It points to the cube's front, 10 mm away, and comes at 1 m/s.
      const Heading heading = Heading::from_angle(pi - 2.0 * pi * leading / corners);
      const BodyState body{{0.1, 0.01}, heading, {-heading.cos, heading.sin, 0.0}};
      const trajectory::Segment segment = trajectory::steady_segment(body, 0.0, whole_tick);
      const MovingOutline mover{shape, segment};
      EXPECT_NEAR(time_of_impact(mover, {cube, still}, 0.0, 0.0, whole_tick), 0.01, 1e-12)
          << leading;
      EXPECT_NEAR(time_of_impact({cube, still}, mover, 0.0, 0.0, whole_tick), 0.01, 1e-12)
          << leading;
      EXPECT_NEAR(time_of_impact_or_penetration(mover, {cube, still}, 1e-12, 0.0, whole_tick), 0.01,
                  1e-12);
    }
  }
}

TEST(FirstTouch, OfTwoThatTouchIsWhenTheyHaveSunkIn) {
  const geometry::Outline cube = geometry::square(0.08);
  const trajectory::Segment still = trajectory::still_segment(BodyState{}, 0.0, whole_tick);
  constexpr double sink = 1e-6;
  for (const double gap : {0.0, -1e-9, 0.5 * sink}) {
    const BodyState body{{0.08 + gap, 0.0}, Heading{}, {-1.0, 0.0, 0.0}};
    const trajectory::Segment segment = trajectory::steady_segment(body, 0.0, whole_tick);
    const double from = std::max(gap, 0.0);
    EXPECT_NEAR(
        time_of_impact_or_penetration({cube, segment}, {cube, still}, sink, 0.0, whole_tick),
        from + sink, 1e-12)
        << gap;
  }
}

TEST(Pose, IsThatOfTheBodyThere) {
  const BodyState body{{0.3, -0.2}, Heading::from_angle(0.7), {0.9, -0.1, 5.0}};
  const trajectory::Segment segment = trajectory::steady_segment(body, 0.001, whole_tick);
  for (const double t : {0.001, 0.01, whole_tick}) {
    const BodyState there = body_at(segment, t);
    const Pose pose = pose_at(segment, t);
    EXPECT_EQ(pose.position, there.position);
    EXPECT_EQ(pose.heading.cos, there.heading.cos);
    EXPECT_EQ(pose.heading.sin, there.heading.sin);
  }
}

}  // namespace
}  // namespace mirocup::simulator::collision
