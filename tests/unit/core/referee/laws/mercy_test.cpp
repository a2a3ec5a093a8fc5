// SPDX-License-Identifier: MIT
//
// Catches a lead that ends the match too early, for the wrong team, or where the rule is off.
#include "core/referee/laws/mercy.hpp"

#include "tests/support/law_test.hpp"

#include <gtest/gtest.h>

namespace mirocup::referee {
namespace {

class Mercy : public test_support::LawTest {
 protected:
  std::optional<Decision> judge(int own, int others) {
    const ByEnd<int> score =
        GetParam() == End::left ? ByEnd<int>{own, others} : ByEnd<int>{others, own};
    Decision goal;
    goal.verdict = Verdict::GOAL;
    goal.clock = 12.5;
    return judge_mercy(pitch_.pitch(), score, goal);
  }
};
INSTANTIATE_TEST_SUITE_P(BothEnds, Mercy, testing::ValuesIn(both_ends), test_support::end_name);

TEST_P(Mercy, EndsTheMatchAtALeadOfTen) {
  EXPECT_FALSE(judge(10, 1));
  const auto end = judge(11, 1);
  expect_call(end, Verdict::MATCH_END, End::left);
  EXPECT_EQ(end->clock, 12.5) << "the clock of the goal";
  pitch_.rules.mercy_goal_diff = 0;
  EXPECT_FALSE(judge(50, 0)) << "off";
}

}  // namespace
}  // namespace mirocup::referee
