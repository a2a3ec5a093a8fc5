// SPDX-License-Identifier: MIT
//
// Catches a fallen robot that blocks the goal unseen, and a stoppage for one that blocks nothing.
#include "core/referee/laws/fallen.hpp"

#include "tests/support/law_test.hpp"

#include <gtest/gtest.h>

namespace mirocup::referee {
namespace {

class FallenRobot : public test_support::LawTest {
 protected:
  std::optional<Decision> judge(const Vec2& where, bool is_fallen) {
    TickFacts s = with_ball({0.0, 0.0});
    s.robots[index_of(End::right)][1] = {where, Heading{}};
    s.fallen[index_of(End::right)][1] = is_fallen;
    return judge_fallen(pitch_.pitch(), seen(s));
  }
};
INSTANTIATE_TEST_SUITE_P(BothEnds, FallenRobot, testing::ValuesIn(both_ends),
                         test_support::end_name);

TEST_P(FallenRobot, OnTheGoalLineStopsPlay) {
  const auto stop = judge({0.73, 0.1}, true);
  expect_call(stop, Verdict::RESTART, End::right);
  EXPECT_EQ(stop->robots[index_of(at(End::right))].to_ulong(), 0b010u);
  EXPECT_FALSE(judge({0.5, 0.1}, true)) << "away from the goals";
  EXPECT_FALSE(judge({0.73, 0.1}, false)) << "it stands";
}

}  // namespace
}  // namespace mirocup::referee
