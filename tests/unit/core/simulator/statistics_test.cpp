// SPDX-License-Identifier: MIT
#include "core/simulator/statistics.hpp"

#include <gtest/gtest.h>

#include <array>

namespace mirocup::simulator {
namespace {

collision::Contact pressing_contact(const Pair& pair, bool presses) {
  collision::Contact c;
  c.pair = pair;
  c.a = pair.a;
  c.b = pair.b();
  c.resting.is_active = presses;
  return c;
}

// Catches a time that counts from the start of the tick instead of the run.
TEST(RunStatistics, TimeOfAnImpactCountsFromTheStartOfTheRun) {
  RunStatistics statistics;
  statistics.origin = 0.066;
  collision::Contact c = pressing_contact(pair_with_obstacle(1, 2), false);
  c.impact.impulse = 0.5;
  add_impact(c, 0.01, statistics);
  ASSERT_EQ(statistics.impacts.size(), 1u);
  EXPECT_DOUBLE_EQ(statistics.impacts[0].time, 0.076);
  EXPECT_EQ(statistics.impacts[0].first, 1);
  EXPECT_EQ(statistics.impacts[0].second, no_body);
  EXPECT_EQ(statistics.impacts[0].impulse, 0.5);
}

// Catches counts of decisions or of contact points: a side on a wall presses with two corners.
TEST(RunStatistics, LastingContactCountsOncePerPairUntilItOpens) {
  RunStatistics statistics;
  const Pair pair = pair_of(0, 1);
  const std::array two{pressing_contact(pair, true), pressing_contact(pair, true)};
  const std::array open{pressing_contact(pair, false)};
  add_pressing(two, bodies_of(pair), statistics);
  add_pressing(two, bodies_of(pair), statistics);
  EXPECT_EQ(statistics.lasting_contacts, 1);
  add_pressing(open, bodies_of(pair), statistics);
  add_pressing(two, bodies_of(pair), statistics);
  EXPECT_EQ(statistics.lasting_contacts, 2);
  EXPECT_EQ(statistics.contact_solves, 4);
}

// Catches a decision about some bodies that forgets the contacts of all others.
TEST(RunStatistics, DecisionAboutSomeBodiesKeepsTheContactsOfOthers) {
  RunStatistics statistics;
  const std::array far{pressing_contact(pair_of(2, 3), true)};
  const std::array here{pressing_contact(pair_of(0, 1), true)};
  add_pressing(far, BodySet(0b1100), statistics);
  add_pressing(here, BodySet(0b0011), statistics);
  EXPECT_TRUE(statistics.pressing[3][2]);
  add_pressing(far, BodySet(0b1100), statistics);
  EXPECT_EQ(statistics.lasting_contacts, 2);
}

}  // namespace
}  // namespace mirocup::simulator
