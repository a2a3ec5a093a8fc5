// SPDX-License-Identifier: MIT
//
// Catches a goal that counts although the keeper was shoved over its line, and one that does not
// although the keeper went there by itself.
#include "core/referee/laws/keeper_push_in.hpp"

#include "core/referee/touches.hpp"
#include "tests/support/law_test.hpp"

#include <gtest/gtest.h>

namespace mirocup::referee {
namespace {

class KeeperPushIn : public test_support::LawTest {
 protected:
  // For ten ticks the right keeper moves 5 mm a tick to its line; then the ball is in.
  std::optional<Decision> push_in(bool is_pressed, double keeper_commanded, double step = 0.005) {
    set_right_keeper();
    std::optional<Decision> called;
    for (int tick = 0; tick <= 10; ++tick) {
      EXPECT_FALSE(called) << "there is no goal yet";
      TickFacts s = with_ball({0.76, 0.0});
      s.robots[index_of(End::right)][0] = {{0.66 + step * tick, 0.0}, Heading{}};
      s.commanded[index_of(End::right)][0] = {keeper_commanded, 0.0};
      s.touched_ball[index_of(End::right)].set(0);
      if (is_pressed) set_touch(s, {End::left, 1}, {End::right, 0});
      const auto goal_at = tick == 10 ? std::optional(at(End::right)) : std::nullopt;
      called = judge_keeper_push_in(pitch_.pitch(), seen(s), occupancy_, goal_at, memory_);
    }
    return called;
  }

  KeeperPushInMemory memory_;
};
INSTANTIATE_TEST_SUITE_P(BothEnds, KeeperPushIn, testing::ValuesIn(both_ends),
                         test_support::end_name);

TEST_P(KeeperPushIn, CancelsTheGoalAndNamesTheAttacker) {
  const auto called = push_in(true, 0.0);
  expect_call(called, Verdict::GOAL_KICK, End::left);
  EXPECT_EQ(called->robots[index_of(at(End::left))].to_ulong(), 0b010u);
}

TEST_P(KeeperPushIn, IsNoneUnlessAnAttackerMovedTheKeeper) {
  EXPECT_FALSE(push_in(false, 0.0)) << "nobody is at the keeper";
  EXPECT_FALSE(push_in(true, 0.1)) << "it drove there itself";
  EXPECT_FALSE(push_in(true, 0.0, 0.0019)) << "it was hardly moved";
}

}  // namespace
}  // namespace mirocup::referee
