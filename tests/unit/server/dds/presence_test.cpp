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
  EXPECT_EQ(verdict.index(), turned.index());
  if (const auto* lost = std::get_if<Disconnected>(&verdict)) {
    const auto& also = std::get<Disconnected>(turned);
    EXPECT_EQ(lost->teams[0], also.teams[1]);
    EXPECT_EQ(lost->teams[1], also.teams[0]);
  }
  return verdict;
}

// The teams that lose: "", "one", "other", "both".
std::string losers(const Verdict& verdict) {
  const auto* lost = std::get_if<Disconnected>(&verdict);
  if (lost == nullptr) return "";
  if (lost->teams[0] && lost->teams[1]) return "both";
  return lost->teams[0] ? "one" : "other";
}

const Standing gone{Away{20.0, 600}, 30.0};  // over its limit since 30 s

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
  for (const Presence& other : std::vector<Presence>{Elsewhere{}, Present{29.0}, Owing{29.0},
                                                     Away{25.0, 700}, Left{25.0, 700}}) {
    EXPECT_TRUE(std::holds_alternative<PlayOn>(judged({Away{25.0, 700}, {}}, {other, {}})));
    EXPECT_TRUE(std::holds_alternative<PlayOn>(judged({Left{25.0, 700}, {}}, {other, {}})));
  }
}

TEST(Presence, LosesForATeamThatIsAwayAlone) {
  EXPECT_EQ(losers(judged(gone, {Elsewhere{}, {}})), "one");
  EXPECT_EQ(losers(judged(gone, {Present{30.1}, {}})), "one");
  EXPECT_EQ(losers(judged(gone, {Owing{30.1}, {}})),
            "one");  // it answers too late, but it is there
}

// Catches a winner that died in the same moment and is noticed a little later.
TEST(Presence, HasNoWinnerThatHasNotBeenSeenSince) {
  for (const Presence& other : std::vector<Presence>{Present{29.9}, Owing{29.9}, Present{0.0},
                                                     Away{29.9, 900}, Left{20.0, 600}}) {
    EXPECT_TRUE(std::holds_alternative<AwaitOther>(judged(gone, {other, {}})));
  }
}

TEST(Presence, LosesForBothOnceBothAreOverTheirLimits) {
  EXPECT_EQ(losers(judged(gone, gone)), "both");
  EXPECT_EQ(losers(judged(gone, {Left{20.1, 603}, 30.1})), "both");
  // The other one comes back after its own limit: too late for it as well.
  EXPECT_EQ(losers(judged(gone, {Present{31.0}, 30.5})), "both");
}

TEST(Presence, IsVoidWhenTheHostsNetworkWasDownForTooLong) {
  EXPECT_TRUE(std::holds_alternative<HostAtFault>(judged(gone, gone, limit + 0.1)));
  EXPECT_TRUE(std::holds_alternative<HostAtFault>(judged(gone, {Elsewhere{}, {}}, limit + 0.1)));
  EXPECT_EQ(losers(judged(gone, gone, limit - 0.1)), "both");
}

}  // namespace
}  // namespace mirocup::dds
