// SPDX-License-Identifier: MIT
#include "core/simulator/stepping/step_islands.hpp"

#include <gtest/gtest.h>

namespace mirocup::simulator::stepping {
namespace {

// Catches an island that is one for all steps: pairs of different steps would never collide.
TEST(StepIslands, BodiesOfDifferentStepsShareNoStep) {
  StepIslands islands;
  islands.begin_step(BodySet(0b0011), 0.0);
  islands.begin_step(BodySet(0b1100), 0.01);
  EXPECT_TRUE(islands.share_step(pair_of(0, 1)));
  EXPECT_TRUE(islands.share_step(pair_of(2, 3)));
  EXPECT_FALSE(islands.share_step(pair_of(1, 2)));
  EXPECT_FALSE(islands.share_step(pair_of(1, 4)));
  EXPECT_EQ(islands.start_of(3), 0.01);
  EXPECT_EQ(islands.island_of(4), BodySet{});
}

// Catches walls that do not belong to a step: a stepped body would bounce against the wall on
// which it presses.
TEST(StepIslands, ObstaclesBelongToTheStepOfAnyBody) {
  StepIslands islands;
  islands.begin_step(BodySet(0b0010), 0.0);
  EXPECT_TRUE(islands.share_step(pair_with_obstacle(1, 0)));
  EXPECT_FALSE(islands.share_step(pair_with_obstacle(0, 0)));
}

// Catches an end that reports bodies which were in no step: they would be stepped from then on.
TEST(StepIslands, EndReportsOnlyBodiesThatWereInAStep) {
  StepIslands islands;
  islands.begin_step(BodySet(0b0111), 0.0);
  EXPECT_EQ(islands.end_step(BodySet(0b1101)), BodySet(0b0101));
  EXPECT_EQ(islands.stepping(), BodySet(0b0010));
  EXPECT_EQ(islands.end_step(BodySet(0b1101)), BodySet{});
  EXPECT_FALSE(islands.share_step(pair_of(0, 1)));
}

}  // namespace
}  // namespace mirocup::simulator::stepping
