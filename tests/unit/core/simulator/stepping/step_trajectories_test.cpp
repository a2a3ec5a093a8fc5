// SPDX-License-Identifier: MIT
//
// Corrected arcs. The corrections themselves are tested with the steps.
#include "core/simulator/stepping/step_trajectories.hpp"

#include <gtest/gtest.h>

namespace mirocup::simulator::stepping {
namespace {

// Catches a rest of a step that is corrected like a whole step, or with the wrong sign.
TEST(StepTrajectories, RestOfAStepIsTheSameTrajectoryAsTheWhole) {
  constexpr double step_start = 0.011;
  constexpr double length = 0.003;
  for (const double side : {1.0, -1.0}) {
    const BodyState begin{{0.3, -0.2}, Heading::from_angle(0.7), {0.8 * side, -0.1 * side, 12.0}};
    const Vec2 correction{2e-3 * side, -1e-3 * side};
    for (const double part : {0.0, 0.3, 0.8}) {
      const double t = step_start + part * length;
      const BodyState now = along_corrected_arc(begin, correction, length, part * length);
      const trajectory::Segment rest =
          corrected_segment(now, correction, step_start, t, step_start + length);
      for (const double later : {part, 0.5 * (part + 1.0), 1.0}) {
        const BodyState there = body_at(rest, step_start + later * length);
        const BodyState expected = along_corrected_arc(begin, correction, length, later * length);
        EXPECT_LT((there.position - expected.position).norm(), 1e-12) << part << ", " << later;
      }
    }
    const BodyState end = along_corrected_arc(begin, correction, length, length);
    EXPECT_EQ(end.position, trajectory::along_arc(begin, length).position);
  }
}

}  // namespace
}  // namespace mirocup::simulator::stepping
