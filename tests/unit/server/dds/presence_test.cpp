// SPDX-License-Identifier: MIT
#include "server/dds/liveliness.hpp"
#include "server/dds/seat.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace mirocup::dds {
namespace {

constexpr double limit = 10.0;

// Judges a pair both ways round, which must give the same with the colours exchanged.
Verdict judged(const Standing& one, const Standing& other, double host_was_down = 0.0) {
  const Verdict verdict = judge_absences({one, other}, host_was_down, limit);
  const Verdict turned = judge_absences({other, one}, host_was_down, limit);
  EXPECT_EQ(verdict.is_hosts_fault, turned.is_hosts_fault);
  EXPECT_EQ(verdict.awaits_other, turned.awaits_other);
  EXPECT_EQ(verdict.lost[0], turned.lost[1]);
  EXPECT_EQ(verdict.lost[1], turned.lost[0]);
  return verdict;
}

// The teams that lose: "", "one", "other", "both".
std::string losers(const Verdict& verdict) {
  if (verdict.lost[0] && verdict.lost[1]) return "both";
  return verdict.lost[0] ? "one" : verdict.lost[1] ? "other" : "";
}

const Standing gone{std::nullopt, 30.0};  // away, and over its limit since 30 s
const Standing away{std::nullopt, {}};
const Standing not_on_network;

Standing seen(double at) {
  return {at, {}};
}

// A process that joins and leaves again and again. Catches a log without end.
TEST(FewWords, SayThatNoMoreFollow) {
  std::vector<std::string> said;
  FewWords words;
  for (int i = 0; i < 14; ++i) {
    words.say([&said](const std::string& text) { said.push_back(text); }, "left");
  }
  ASSERT_EQ(said.size(), 10U);
  EXPECT_EQ(said.back(), "left; further messages of this kind are counted, but not printed");
}

TEST(Presence, LetsATeamBeAwayWithinItsLimit) {
  for (const Standing& other : {not_on_network, seen(29.0), away}) {
    const Verdict verdict = judged(away, other);
    EXPECT_FALSE(verdict.ends_leg() || verdict.awaits_other);
  }
}

TEST(Presence, LosesForATeamThatIsAwayAlone) {
  EXPECT_EQ(losers(judged(gone, not_on_network)), "one");
  EXPECT_EQ(losers(judged(gone, seen(30.1))), "one");
}

// Catches a winner that died in the same moment and is noticed a little later.
TEST(Presence, HasNoWinnerThatHasNotBeenSeenSince) {
  for (const Standing& other : {seen(29.9), seen(0.0), away}) {
    const Verdict verdict = judged(gone, other);
    EXPECT_TRUE(verdict.awaits_other && !verdict.ends_leg());
  }
}

TEST(Presence, LosesForBothOnceBothAreOverTheirLimits) {
  EXPECT_EQ(losers(judged(gone, gone)), "both");
  EXPECT_EQ(losers(judged(gone, {std::nullopt, 30.1})), "both");
  // The other one comes back after its own limit: too late for it as well.
  EXPECT_EQ(losers(judged(gone, {31.0, 30.5})), "both");
}

TEST(Presence, IsVoidWhenTheHostsNetworkWasDownForTooLong) {
  EXPECT_TRUE(judged(gone, gone, limit + 0.1).is_hosts_fault);
  EXPECT_TRUE(judged(gone, not_on_network, limit + 0.1).is_hosts_fault);
  EXPECT_EQ(losers(judged(gone, gone, limit - 0.1)), "both");
}

}  // namespace
}  // namespace mirocup::dds
