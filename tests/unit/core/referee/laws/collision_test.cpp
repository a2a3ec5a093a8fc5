// SPDX-License-Identifier: MIT
//
// Catches a collision below the limits, one that is noted twice, and one that blames the slower
// robot.
#include "core/referee/laws/collision.hpp"

#include "core/referee/touches.hpp"
#include "tests/support/law_test.hpp"

#include <gtest/gtest.h>

namespace mirocup::referee {
namespace {

class Collision : public test_support::LawTest {
 protected:
  Collision() { pitch_.rules.collision_mps = 1.0; }

  // The left robot 0 meets the right robot 0 at this speed, the ball in the left half.
  std::optional<Decision> meet(double speed) {
    TickFacts s = with_ball({-0.3, 0.3});
    s.robots[index_of(End::left)][0] = {{0.0, 0.0}, Heading{}};
    s.robots[index_of(End::right)][0] = {{0.08, 0.0}, Heading{}};
    s.velocity[index_of(End::left)][0] = {speed, 0.0};
    set_touch(s, {End::left, 0}, {End::right, 0});
    return judge_collision(pitch_.pitch(), seen(s), memory_);
  }

  CollisionMemory memory_;
};
INSTANTIATE_TEST_SUITE_P(BothEnds, Collision, testing::ValuesIn(both_ends), test_support::end_name);

TEST_P(Collision, IsNotedOnceAndNamesBothRobots) {
  const auto note = meet(1.01);
  expect_call(note, Verdict::NONE, End::left);  // the faster one
  for (const RobotSet& robots : note->robots) EXPECT_EQ(robots.to_ulong(), 0b001u);
  EXPECT_FALSE(meet(1.01)) << "they still touch";
}

TEST_P(Collision, IsCalledLikeAPushWhereTheRulesSaySo) {
  pitch_.rules.collision_foul = true;
  const auto foul = meet(1.01);
  expect_call(foul, Verdict::FREE_KICK, End::left);  // the ball is in the offender's half
  EXPECT_EQ(foul->law, Law::collision);
}

TEST_P(Collision, IsIgnoredBelowTheLimitAndByDefault) {
  EXPECT_FALSE(meet(0.99));
  pitch_.rules = make_rules(Preset::mirosot);
  EXPECT_FALSE(meet(5.0));
}

}  // namespace
}  // namespace mirocup::referee
