// SPDX-License-Identifier: MIT
//
// Catches a search that leaves out a corner, or takes a body to be where it is not.
#include "core/simulator/collision/time_of_impact.hpp"

#include "core/base/math.hpp"

#include <gtest/gtest.h>

#include <algorithm>
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

}  // namespace
}  // namespace mirocup::simulator::collision
