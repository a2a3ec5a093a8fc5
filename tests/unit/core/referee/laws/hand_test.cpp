// SPDX-License-Identifier: MIT
//
// Catches a hand that is called where the rules allow it, and one that is called against the wrong
// team.
#include "core/referee/laws/hand.hpp"

#include "tests/support/law_test.hpp"

#include <gtest/gtest.h>

namespace mirocup::referee {
namespace {

class HandOnTheField : public test_support::LawTest {
 protected:
  std::optional<Decision> judge(bool left, bool right) {
    TickFacts s = with_ball({-0.3, 0.0});
    s.hand = {left, right};
    return judge_hand(pitch_.pitch(), seen(s));
  }
};
INSTANTIATE_TEST_SUITE_P(BothEnds, HandOnTheField, testing::ValuesIn(both_ends),
                         test_support::end_name);

TEST_P(HandOnTheField, CostsAPenaltyWhereTheRulesSaySo) {
  EXPECT_FALSE(judge(true, false)) << "off by default";
  pitch_.rules.hand_penalty = true;
  EXPECT_FALSE(judge(false, false));
  expect_call(judge(true, false), Verdict::PENALTY_KICK, End::left, End::right);
}

TEST_P(HandOnTheField, ByBothTeamsIsCalledAgainstTheOneNearerToTheBall) {
  pitch_.rules.hand_penalty = true;
  EXPECT_EQ(judge(true, true)->team, at(End::left));
}

}  // namespace
}  // namespace mirocup::referee
