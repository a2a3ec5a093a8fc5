// SPDX-License-Identifier: MIT
#include "core/simulator/impact/rest_thresholds.hpp"

#include "core/base/math.hpp"
#include "core/simulator/trajectory/taylor_series.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace mirocup::simulator::impact {
namespace {

const Tolerances tolerances;
const BodySet crowd{0b111};  // bodies 0, 1 and 2

// Faster than anything on the field, m/s: below such a threshold nothing bounces.
constexpr double any_speed = 10.0;

// Returns how many events of n bodies that have met m bodies use up the budget: each costs (n m)^2.
int events_in_budget(int n, int m) {
  const int cost = n * m * n * m;
  return (tolerances.event_budget + cost - 1) / cost;
}

RestThresholds fresh() {
  RestThresholds thresholds(tolerances);
  thresholds.begin_tick({});
  return thresholds;
}

// A crowd's chatter must not take the bounce from a ball at the other end of the field.
TEST(RestThresholds, GrowOnlyForBodiesWithImpacts) {
  RestThresholds thresholds = fresh();
  for (int i = 0; i < 12; ++i) thresholds.note_impact(pair_of(0, 1), 1e-3);
  EXPECT_DOUBLE_EQ(thresholds.restitution_threshold(pair_of(2, 3)),
                   tolerances.first_restitution_threshold);
  EXPECT_DOUBLE_EQ(thresholds.penetration(pair_of(2, 3)), tolerances.penetration);
  EXPECT_LE(thresholds.min_slip_speed(2), tolerances.first_restitution_threshold);
  EXPECT_GT(thresholds.restitution_threshold(pair_of(2, 1)), any_speed);
  EXPECT_GT(thresholds.restitution_threshold(pair_with_obstacle(1, 3)), any_speed);
}

// However slow: slow rebounds and approaches would be wrong by the thresholds of a crowd otherwise.
TEST(RestThresholds, ABodysFirstImpactBounces) {
  RestThresholds thresholds = fresh();
  EXPECT_DOUBLE_EQ(thresholds.restitution_threshold(pair_of(0, 1)),
                   tolerances.first_restitution_threshold);
  thresholds.note_impact(pair_of(0, 1), 1e-3);
  EXPECT_DOUBLE_EQ(thresholds.restitution_threshold(pair_of(0, 1)),
                   tolerances.first_restitution_threshold);
  thresholds.note_impact(pair_of(1, 2), 1e-3);
  EXPECT_GT(thresholds.restitution_threshold(pair_of(0, 1)), tolerances.restitution_threshold);
}

// A contact that lasts from the last tick is no new impact.
TEST(RestThresholds, LastingContactsRestAboveRounding) {
  RestThresholds thresholds = fresh();
  BodySet touching;
  touching.set(0);
  touching.set(1);
  thresholds.begin_tick(touching);
  EXPECT_DOUBLE_EQ(thresholds.restitution_threshold(pair_of(0, 1)),
                   tolerances.first_restitution_threshold);
  thresholds.begin_tick(touching);
  EXPECT_DOUBLE_EQ(thresholds.restitution_threshold(pair_of(0, 1)),
                   tolerances.restitution_threshold);
  EXPECT_DOUBLE_EQ(thresholds.restitution_threshold(pair_of(0, 2)),
                   tolerances.first_restitution_threshold);
  EXPECT_DOUBLE_EQ(thresholds.min_slip_speed(0), tolerances.min_slip_speed);
  thresholds.forget();
  thresholds.begin_tick(touching);
  EXPECT_DOUBLE_EQ(thresholds.restitution_threshold(pair_of(0, 1)),
                   tolerances.first_restitution_threshold);
}

// A spinning robot meets the wall with one corner after the other: each is an impact of its own.
TEST(RestThresholds, RareImpactsAreForgotten) {
  RestThresholds thresholds = fresh();
  for (int i = 1; i <= 100; ++i) {
    thresholds.note_impact(pair_of(0, 1), 1.01 * tolerances.impact_memory * i);
    EXPECT_DOUBLE_EQ(thresholds.restitution_threshold(pair_of(0, 1)),
                     tolerances.first_restitution_threshold)
        << i;
  }
}

// Otherwise a body in a crowd would start with the first threshold again after each pause.
TEST(RestThresholds, ManyImpactsAreNotForgotten) {
  RestThresholds thresholds = fresh();
  for (int i = 0; i < tolerances.remembered_impacts; ++i) {
    thresholds.note_impact(pair_of(0, 1), 1e-3);
  }
  const double after_many = thresholds.restitution_threshold(pair_of(0, 1));
  thresholds.note_impact(pair_of(0, 1), 1.0);
  EXPECT_GT(thresholds.restitution_threshold(pair_of(0, 1)), after_many);
}

// Wheels that grip and slide again in turn throw a robot at the wall that it touches, without
// a new collision: that has to end, too. But the bounce of a collision is not counted twice.
TEST(RestThresholds, ABounceCountsAsOneImpact) {
  RestThresholds thresholds = fresh();
  thresholds.note_impact(pair_of(4, 5), 1e-3);
  for (int i = 0; i < 30; ++i) thresholds.note_bounce(pair_of(4, 5), 1e-3);
  EXPECT_DOUBLE_EQ(thresholds.restitution_threshold(pair_of(4, 5)),
                   tolerances.first_restitution_threshold);
  for (int i = 0; i < 30; ++i) thresholds.note_bounce(pair_of(4, 5), 1e-3 + 1e-7 * i);
  EXPECT_GT(thresholds.restitution_threshold(pair_of(4, 5)), any_speed);
}

TEST(RestThresholds, PenetrationStaysBelowTheContactGap) {
  RestThresholds thresholds = fresh();
  for (int i = 0; i < 1000; ++i) thresholds.note_impact(pair_of(0, 1), 1e-3);
  EXPECT_DOUBLE_EQ(thresholds.penetration(pair_of(0, 1)), tolerances.contact_gap);
}

// Catches wheels that are stopped at a slip at which contacts still bounce.
TEST(RestThresholds, SlipLimitStaysBelowTheRestitutionThreshold) {
  RestThresholds thresholds = fresh();
  for (int i = 0; i < 20; ++i) {
    EXPECT_LE(thresholds.min_slip_speed(1), thresholds.restitution_threshold(pair_of(0, 1)));
    thresholds.note_impact(pair_of(0, 1), 1e-3);
  }
}

// Contacts that would let go and press again at once are held for longer, until that ends.
TEST(RestThresholds, MinDurationGrowsFasterWhereItForcedAnEnd) {
  RestThresholds thresholds = fresh();
  const double first = thresholds.min_duration();
  thresholds.note_event(crowd, false);
  const double calm = thresholds.min_duration() / first;
  thresholds.note_event(crowd, true);
  EXPECT_GT(thresholds.min_duration() / (first * calm), 2.0 * calm);
  for (int i = 0; i < 100; ++i) thresholds.note_event(crowd, true);
  EXPECT_LT(thresholds.min_duration(), 0.01);
}

// Otherwise wheels that grip and slide in alternation would use up the tick's event budget.
TEST(RestThresholds, SlipThresholdGrowsUpToTheRestitutionThreshold) {
  RestThresholds thresholds = fresh();
  double before = thresholds.slip_threshold();
  double least_growth = infinity;
  for (int i = 0; i < 1000 && before < tolerances.restitution_threshold; ++i) {
    thresholds.note_event(crowd, false);
    const double now = thresholds.slip_threshold();
    ASSERT_GT(now, before) << i;
    if (before > tolerances.slow_slip && now < tolerances.restitution_threshold) {
      least_growth = std::min(least_growth, now / before);
    }
    before = now;
  }
  EXPECT_LT(least_growth, tolerances.slip_growth_per_event);  // slower above slow_slip
  thresholds.note_event(crowd, false);
  EXPECT_DOUBLE_EQ(thresholds.slip_threshold(), tolerances.restitution_threshold);
}

// The longer nothing has collided, the longer a curve may be. Otherwise each would be as short as
// those of a burst that is over.
TEST(RestThresholds, CurvesMayBeLongerAfterABurst) {
  RestThresholds thresholds = fresh();
  EXPECT_EQ(thresholds.preferred_duration(1e-3), trajectory::never);
  for (int i = 1; i <= 10; ++i) thresholds.note_impact(pair_of(0, 1), 1e-5 * i);
  EXPECT_LT(thresholds.preferred_duration(1e-4), 1e-4);
  EXPECT_GT(thresholds.preferred_duration(5e-3), 5e-3);
}

// Catches a budget that counts events alone, since one of 22 robots costs far more than one of two;
// and one that other bodies pay, too.
TEST(RestThresholds, AnEventOfMoreBodiesCostsMore) {
  const auto followed = [](const BodySet& bodies) {
    RestThresholds thresholds = fresh();
    int events = 0;
    while (!(thresholds.over_budget() & bodies).any()) {
      thresholds.note_event(bodies, false);
      ++events;
    }
    EXPECT_TRUE((thresholds.over_budget() & ~bodies).none());
    return events;
  };
  EXPECT_EQ(followed(crowd), events_in_budget(3, 3));
  EXPECT_EQ(followed(BodySet{0b1}), events_in_budget(1, 1));
}

// Catches a budget that depends on the involved bodies alone: in a crowd most events have two.
TEST(RestThresholds, ABodyThatHasMetManyPaysMore) {
  const auto followed = [](int met) {
    RestThresholds thresholds = fresh();
    for (int other = 2; other < 2 + met; ++other) thresholds.note_impact(pair_of(0, other), 1e-3);
    int events = 0;
    while (!thresholds.over_budget()[1]) {
      thresholds.note_impact(pair_of(0, 1), 2e-3);
      thresholds.note_event(bodies_of(pair_of(0, 1)), false);
      ++events;
    }
    return events;
  };
  EXPECT_EQ(followed(0), events_in_budget(2, 2));
  EXPECT_EQ(followed(3), events_in_budget(2, 5));
}

// A large island that went over budget is over budget from the start of the next tick, and no other
// island is. Catches a budget that waits for events, and one that steps a row at rest.
TEST(RestThresholds, ALargeIslandStaysOverBudget) {
  const BodySet four(0b1111);
  const BodySet five(0b1111100000);
  const BodySet at_rest(0b11111 << 10);
  RestThresholds thresholds = fresh();
  for (int tick = 0; tick < 3; ++tick) {
    for (const BodySet& island : {four, five, at_rest}) thresholds.note_island(island);
    EXPECT_EQ(thresholds.over_budget(), tick == 0 ? BodySet() : five);
    for (int event = 0; event < 2; ++event) thresholds.note_event(four, false);
    if (tick == 0) thresholds.note_event(five, false);
    thresholds.begin_tick({});
  }
  thresholds.forget();
  thresholds.begin_tick({});
  thresholds.note_island(five);
  EXPECT_EQ(thresholds.over_budget(), BodySet());
}

TEST(RestThresholds, EachTickStartsAfresh) {
  RestThresholds thresholds = fresh();
  for (int i = 0; i < 12; ++i) {
    thresholds.note_impact(pair_of(0, 1), 1e-3);
    thresholds.note_bounce(pair_of(0, 1), 2e-3);
    thresholds.note_event(crowd, true);
  }
  thresholds.begin_tick({});
  EXPECT_DOUBLE_EQ(thresholds.restitution_threshold(pair_of(0, 1)),
                   tolerances.restitution_threshold);
  EXPECT_DOUBLE_EQ(thresholds.penetration(pair_of(0, 1)), tolerances.penetration);
  EXPECT_DOUBLE_EQ(thresholds.min_duration(), tolerances.min_contact_duration);
}

}  // namespace
}  // namespace mirocup::simulator::impact
