// SPDX-License-Identifier: MIT
//
// Catches a check that gives a slow team as long legs as a quick one, and one that makes the legs
// of a quick team shorter on a busy machine.
#include "programs/check/check_plan.hpp"

#include <gtest/gtest.h>

#include <cstdint>

namespace mirocup::app {
namespace {

struct Played {
  double used = 0.0;  // s of processor time
  int whole_legs = 0;
  std::uint64_t ticks = 0;
  std::uint64_t fewest_ticks = UINT64_MAX;  // of a leg that must be played
};

// Counts what a check would play of a team that takes so long to load and for a tick, s. Its legs
// are those of entry_check.cpp. Where its memory is watched it takes three times as long.
Played check_of(double start, double tick) {
  constexpr std::uint64_t whole_leg = 18'200, knockout = 400, moment = 60;
  CheckPlan plan;
  Played played;
  const auto play = [&](double share, std::uint64_t needed, double factor) {
    std::uint32_t ticks = 0;
    while (ticks < needed &&
           ticks * factor * tick <= CheckPlan::most_use(share, ticks, factor > 1.0))
      ++ticks;
    plan.add(start + static_cast<double>(ticks) * factor * tick, start);
    played.ticks += ticks;
    return std::uint64_t{ticks};
  };
  const auto must_play = [&](int legs, std::uint64_t needed, double factor) {
    played.fewest_ticks = std::min(played.fewest_ticks, play(plan.share_of(legs), needed, factor));
  };
  play(CheckPlan::longest, 0, 1.0);
  play(2.0, 100, 1.0);
  must_play(5, whole_leg, 1.0);
  must_play(4, whole_leg, 1.0);
  must_play(3, knockout, 1.0);
  for (int restart = 0; restart < 10; ++restart) {
    if (plan.has_room_for(moment * tick, 2, tick)) play(CheckPlan::longest, moment, 1.0);
  }
  for (int fill = 0; fill < 3; ++fill)
    if (fill == 0 || plan.has_room_for(0.0, 1, tick)) must_play(2, knockout, 3.0);
  must_play(1, 5000, 3.0);
  played.used = plan.used();
  return played;
}

TEST(CheckPlan, KeepsASlowTeamWithinItsTime) {
  // Teams that take more than a leg gives, and teams in Python that load for long.
  for (const double tick : {1.1e-3, 5e-3, 15e-3}) {
    for (const double start : {0.001, 0.2, 1.0, 2.0}) {
      const Played played = check_of(start, tick);
      EXPECT_LE(played.used, CheckPlan::all + 3 * tick + 0.6) << start << " " << tick;
      EXPECT_GE(played.fewest_ticks, 10u) << start << " " << tick;
    }
  }
}

// Half of the budget of a tick is 0.5 ms, which a busy machine doubles.
TEST(CheckPlan, LeavesTheLegsOfATeamWholeThatStaysBelowHalfOfItsBudget) {
  for (const double tick : {1e-5, 0.3e-3, 0.5e-3, 0.999e-3}) {
    const Played played = check_of(0.5, tick);
    EXPECT_EQ(played.ticks, 0u + 100 + 2 * 18'200 + 4 * 400 + 10 * 60 + 5000) << tick;
    EXPECT_LE(played.used, 70.0) << tick;
  }
}

TEST(CheckPlan, BoundsWhatAnEntryCanSpendThatLoadsAsLongAsItMay) {
  EXPECT_LE(check_of(CheckPlan::most_start, 15e-3).used, 35.0);
}

TEST(CheckPlan, HasTimeOfItsOwnForCauses) {
  CheckPlan plan;
  plan.add(CheckPlan::all, 0.1);
  EXPECT_FALSE(plan.has_room_for(CheckPlan::shortest, 0, 2e-3));
  plan.look_for_causes();
  EXPECT_EQ(plan.share_of(1), CheckPlan::longest);
  plan.add(CheckPlan::causes, 0.1);
  EXPECT_FALSE(plan.has_room_for(CheckPlan::shortest, 0, 2e-3));
  EXPECT_EQ(plan.share_of(1), CheckPlan::shortest);
}

}  // namespace
}  // namespace mirocup::app
