// SPDX-License-Identifier: MIT
#include "core/simulator/impact/rest_thresholds.hpp"

#include "core/simulator/trajectory/taylor_series.hpp"

#include <gtest/gtest.h>

namespace mirocup::simulator::impact {
namespace {

const Tolerances tolerances;
const BodySet crowd{0b111};  // bodies 0, 1 and 2

RestThresholds fresh() {
  RestThresholds thresholds(tolerances);
  thresholds.begin_tick({});
  return thresholds;
}

// A crowd's chatter must not take the bounce from a ball at the other end of the field.
TEST(RestThresholds, WearsOffForThoseWhoAreTouchedOnly) {
  RestThresholds thresholds = fresh();
  for (int i = 0; i < 12; ++i) thresholds.note_impact(pair_of(0, 1), 1e-3);
  EXPECT_DOUBLE_EQ(thresholds.restitution_threshold(pair_of(2, 3)),
                   tolerances.first_restitution_threshold);
  EXPECT_DOUBLE_EQ(thresholds.penetration(pair_of(2, 3)), tolerances.penetration);
  EXPECT_LE(thresholds.min_slip_speed(2), tolerances.first_restitution_threshold);
  EXPECT_GT(thresholds.restitution_threshold(pair_of(2, 1)),
            1000.0 * tolerances.restitution_threshold);
  EXPECT_GT(thresholds.restitution_threshold(pair_with_obstacle(1, 3)),
            1000.0 * tolerances.restitution_threshold);
}

// However slow: or slow rebounds, and slow approaches, would be off by what rests in a crowd.
TEST(RestThresholds, ABodysFirstTouchBounces) {
  RestThresholds thresholds = fresh();
  EXPECT_DOUBLE_EQ(thresholds.restitution_threshold(pair_of(0, 1)),
                   tolerances.first_restitution_threshold);
  thresholds.note_impact(pair_of(0, 1), 1e-3);
  EXPECT_DOUBLE_EQ(thresholds.restitution_threshold(pair_of(0, 1)),
                   tolerances.first_restitution_threshold);
  thresholds.note_impact(pair_of(1, 2), 1e-3);
  EXPECT_GT(thresholds.restitution_threshold(pair_of(0, 1)), tolerances.restitution_threshold);
}

// What the last tick left in contact is no new touch.
TEST(RestThresholds, BodiesInCompanyAreAtRestAboveRounding) {
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
TEST(RestThresholds, TouchesNowAndThenAreForgotten) {
  RestThresholds thresholds = fresh();
  for (int i = 1; i <= 100; ++i) {
    thresholds.note_impact(pair_of(0, 1), 1.01 * tolerances.impact_memory * i);
    EXPECT_DOUBLE_EQ(thresholds.restitution_threshold(pair_of(0, 1)),
                     tolerances.first_restitution_threshold)
        << i;
  }
}

// Or a body in a crowd would be followed as closely after each pause.
TEST(RestThresholds, ManyTouchesAreNotForgotten) {
  RestThresholds thresholds = fresh();
  for (int i = 0; i < tolerances.remembered_touches; ++i) {
    thresholds.note_impact(pair_of(0, 1), 1e-3);
  }
  const double tired = thresholds.restitution_threshold(pair_of(0, 1));
  thresholds.note_impact(pair_of(0, 1), 1.0);
  EXPECT_GT(thresholds.restitution_threshold(pair_of(0, 1)), tired);
}

// WheelState that grip and slide again in turn throw a robot at the wall that it touches, without a new
// touch: that has to end, too. But what a touch brings about is not counted twice.
TEST(RestThresholds, BouncesCountAsTouchesOnce) {
  RestThresholds thresholds = fresh();
  thresholds.note_impact(pair_of(4, 5), 1e-3);
  for (int i = 0; i < 30; ++i) thresholds.note_bounce(pair_of(4, 5), 1e-3);
  EXPECT_DOUBLE_EQ(thresholds.restitution_threshold(pair_of(4, 5)),
                   tolerances.first_restitution_threshold);
  for (int i = 0; i < 30; ++i) thresholds.note_bounce(pair_of(4, 5), 1e-3 + 1e-7 * i);
  EXPECT_GT(thresholds.restitution_threshold(pair_of(4, 5)), 1.0);
}

TEST(RestThresholds, NeverLetsAPairSinkDeeperThanContactsReach) {
  RestThresholds thresholds = fresh();
  for (int i = 0; i < 1000; ++i) thresholds.note_impact(pair_of(0, 1), 1e-3);
  EXPECT_DOUBLE_EQ(thresholds.penetration(pair_of(0, 1)), tolerances.contact_gap);
}

// WheelState are not stopped faster than anything else that rests.
TEST(RestThresholds, StopsNoFasterSlideThanWhatRests) {
  RestThresholds thresholds = fresh();
  for (int i = 0; i < 20; ++i) {
    EXPECT_LE(thresholds.min_slip_speed(1), thresholds.restitution_threshold(pair_of(0, 1)));
    thresholds.note_impact(pair_of(0, 1), 1e-3);
  }
}

// Contacts that would let go and press again at once are held for longer, until that ends.
TEST(RestThresholds, HoldsLongerWhereItWasForced) {
  RestThresholds thresholds = fresh();
  const double first = thresholds.min_duration();
  thresholds.note_event(crowd, false);
  const double calm = thresholds.min_duration() / first;
  thresholds.note_event(crowd, true);
  EXPECT_GT(thresholds.min_duration() / (first * calm), 2.0 * calm);
  for (int i = 0; i < 100; ++i) thresholds.note_event(crowd, true);
  EXPECT_LT(thresholds.min_duration(), 0.01);
}

// WheelState that grip and slide on at some speed would do so until the tick's events are used up.
TEST(RestThresholds, StopsFasterSlidesTheLongerATickTakes) {
  RestThresholds thresholds = fresh();
  for (int i = 0; i < 30; ++i) thresholds.note_event(crowd, false);
  EXPECT_LT(thresholds.slip_threshold(), 2.0 * tolerances.slow_slip);
  for (int i = 0; i < 100; ++i) thresholds.note_event(crowd, false);
  EXPECT_GT(thresholds.slip_threshold(), 20.0 * tolerances.slow_slip);
  for (int i = 0; i < 1000; ++i) thresholds.note_event(crowd, false);
  EXPECT_LE(thresholds.slip_threshold(), tolerances.restitution_threshold);
}

// A curve is wanted longer the longer nothing has touched: or each would be as short as those of a
// burst that is over.
TEST(RestThresholds, AsksForLongerCurvesAfterABurst) {
  RestThresholds thresholds = fresh();
  EXPECT_EQ(thresholds.preferred_duration(1e-3), trajectory::never);
  for (int i = 1; i <= 10; ++i) thresholds.note_impact(pair_of(0, 1), 1e-5 * i);
  EXPECT_LT(thresholds.preferred_duration(1e-4), 1e-4);
  EXPECT_GT(thresholds.preferred_duration(5e-3), 5e-3);
}

// Many events of a few are followed, few of many, and those of a crowd end nobody else's. Catches a
// budget that counts events alone: one of 22 robots costs far more than one of two.
TEST(RestThresholds, FollowsFewerEventsOfMoreBodies) {
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
  EXPECT_EQ(followed(crowd), (tolerances.event_budget + 80) / 81);
  EXPECT_EQ(followed(BodySet{0b1}), tolerances.event_budget);
}

// Two that meet again and again are followed for longer than two of whom one has met others before. Catches
// a budget that sees only who is involved: in a crowd most events are of two.
TEST(RestThresholds, FollowsWhoHasMetManyLessClosely) {
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
  EXPECT_EQ(followed(0), (tolerances.event_budget + 15) / 16);
  EXPECT_EQ(followed(3), (tolerances.event_budget + 99) / 100);
}

// Groups that were too much in a tick go in steps from the next one's begin while they are large, and
// concern no others. Catches one that waits for events, and one that does not let a row at rest be hit.
TEST(RestThresholds, DoesNotFollowLargeGroupsAgain) {
  const BodySet four(0b1111);
  const BodySet five(0b1111100000);
  const BodySet at_rest(0b11111 << 10);
  RestThresholds thresholds = fresh();
  for (int tick = 0; tick < 3; ++tick) {
    for (const BodySet& group : {four, five, at_rest}) thresholds.note_island(group);
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

TEST(RestThresholds, IsFreshInEachTick) {
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
