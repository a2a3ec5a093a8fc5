// SPDX-License-Identifier: MIT
//
// Catches a search that leaves out a corner, or takes a body to be where it is not.
#include "core/simulator/collision/time_of_impact.hpp"

#include "core/base/math.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

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

TEST(TimeOfImpact, IsThatOfTheLeadingCorner) {
  const geometry::Outline cube = geometry::square(0.08);
  const trajectory::Segment still = trajectory::still_segment(BodyState{}, 0.0, whole_tick);
  for (int corners = 3; corners <= geometry::max_corners; ++corners) {
    const geometry::Outline shape = regular_polygon(corners, 0.05);
    for (int leading = 0; leading < corners; ++leading) {
      // It points to the cube's front, 10 mm away, and comes at 1 m/s.
      const Heading heading = Heading::from_angle(pi - 2.0 * pi * leading / corners);
      const BodyState body{{0.1, 0.01}, heading, {-heading.cos, heading.sin, 0.0}};
      const trajectory::Segment segment = trajectory::steady_segment(body, 0.0, whole_tick);
      const MovingOutline moving{shape, segment};
      EXPECT_NEAR(time_of_impact(moving, {cube, still}, 0.0, 0.0, whole_tick), 0.01, 1e-12)
          << leading;
      EXPECT_NEAR(time_of_impact({cube, still}, moving, 0.0, 0.0, whole_tick), 0.01, 1e-12)
          << leading;
      EXPECT_NEAR(time_of_impact_or_penetration(moving, {cube, still}, 1e-12, 0.0, whole_tick),
                  0.01, 1e-12);
    }
  }
}

TEST(TimeOfImpact, OfTouchingBodiesIsWhenTheyPenetrate) {
  const geometry::Outline cube = geometry::square(0.08);
  const trajectory::Segment still = trajectory::still_segment(BodyState{}, 0.0, whole_tick);
  constexpr double penetration = 1e-6;
  for (const double gap : {0.0, -1e-9, 0.5 * penetration}) {
    const BodyState body{{0.08 + gap, 0.0}, Heading{}, {-1.0, 0.0, 0.0}};
    const trajectory::Segment segment = trajectory::steady_segment(body, 0.0, whole_tick);
    const double from = std::max(gap, 0.0);
    EXPECT_NEAR(
        time_of_impact_or_penetration({cube, segment}, {cube, still}, penetration, 0.0, whole_tick),
        from + penetration, 1e-12)
        << gap;
  }
}

// A square that spins in place beside a wall: its corner comes down at a known angle. Catches a
// corner that is taken to move on a straight line.
TEST(TimeOfImpact, OfASpinningSquareIsAClosedForm) {
  constexpr double side = 0.08;
  constexpr double omega = 10.0;  // rad/s
  const geometry::Outline square = geometry::square(side);
  for (const double angle : {0.05, 0.1, 0.25}) {
    // A corner is in the direction pi/4 and comes to height radius sin(pi/4 + angle).
    const double height = square.radius * std::sin(0.25 * pi + angle);
    const field::Wall below{{0.0, 1.0}, -height};
    const BodyState body{{0.0, 0.0}, Heading{}, {0.0, 0.0, omega}};
    const trajectory::Segment segment = trajectory::steady_segment(body, 0.0, whole_tick);
    EXPECT_NEAR(time_of_impact({square, segment}, below, 0.0, 0.0, whole_tick), angle / omega,
                1e-11)
        << angle;
  }
}

// Body and pose on an arc of known radius. Catches a pose that leaves out the sideways velocity.
TEST(Segment, PoseAndBodyFollowAnArc) {
  constexpr double begin = 0.001;
  const BodyState body{{0.3, -0.2}, Heading::from_angle(0.7), {0.9, -0.1, 5.0}};
  const trajectory::Segment segment = trajectory::steady_segment(body, begin, whole_tick);
  for (const double t : {begin, 0.01, whole_tick}) {
    const double turned = 5.0 * (t - begin);
    // The integral of the velocity, which turns with the body.
    const Vec2 path{(0.9 * std::sin(turned) + 0.1 * (1.0 - std::cos(turned))) / 5.0,
                    (0.9 * (1.0 - std::cos(turned)) - 0.1 * std::sin(turned)) / 5.0};
    const Vec2 place = body.position + body.heading.to_world(path);
    const Heading heading = Heading::from_angle(0.7 + turned);
    const Pose pose = pose_at(segment, t);
    EXPECT_NEAR((pose.position - place).norm(), 0.0, 1e-13);
    EXPECT_NEAR(pose.heading.cos, heading.cos, 1e-13);
    EXPECT_NEAR(pose.heading.sin, heading.sin, 1e-13);
    EXPECT_NEAR((body_at(segment, t).position - place).norm(), 0.0, 1e-13);
    EXPECT_NEAR(body_at(segment, t).twist.left, -0.1, 1e-13);
  }
}

}  // namespace
}  // namespace mirocup::simulator::collision
