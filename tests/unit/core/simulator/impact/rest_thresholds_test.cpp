// SPDX-License-Identifier: MIT
#include "core/simulator/impact/rest_thresholds.hpp"

#include "core/simulator/trajectory/taylor_series.hpp"

#include <gtest/gtest.h>

namespace mirocup::simulator {
namespace {

const Tolerances tolerances;
const BodySet crowd{0b111};  // bodies 0, 1 and 2

Patience fresh() {
  Patience patience(tolerances);
  patience.begin_tick({});
  return patience;
}

// A crowd's chatter must not take the bounce from a ball at the other end of the field.
TEST(Patience, WearsOffForThoseWhoAreTouchedOnly) {
  Patience patience = fresh();
  for (int i = 0; i < 12; ++i) patience.note_touch(pair_of(0, 1), 1e-3);
  EXPECT_DOUBLE_EQ(patience.rest_speed(pair_of(2, 3)), tolerances.first_rest_speed);
  EXPECT_DOUBLE_EQ(patience.sink(pair_of(2, 3)), tolerances.sink);
  EXPECT_LE(patience.brief_slide(2), tolerances.first_rest_speed);
  EXPECT_GT(patience.rest_speed(pair_of(2, 1)), 1000.0 * tolerances.rest_speed);
  EXPECT_GT(patience.rest_speed(pair_with_obstacle(1, 3)), 1000.0 * tolerances.rest_speed);
}

// However slow: or slow rebounds, and slow approaches, would be off by what rests in a crowd.
TEST(Patience, ABodysFirstTouchBounces) {
  Patience patience = fresh();
  EXPECT_DOUBLE_EQ(patience.rest_speed(pair_of(0, 1)), tolerances.first_rest_speed);
  patience.note_touch(pair_of(0, 1), 1e-3);
  EXPECT_DOUBLE_EQ(patience.rest_speed(pair_of(0, 1)), tolerances.first_rest_speed);
  patience.note_touch(pair_of(1, 2), 1e-3);
  EXPECT_GT(patience.rest_speed(pair_of(0, 1)), tolerances.rest_speed);
}

// What the last tick left in contact is no new touch.
TEST(Patience, BodiesInCompanyAreAtRestAboveRounding) {
  Patience patience = fresh();
  BodySet touching;
  touching.set(0);
  touching.set(1);
  patience.begin_tick(touching);
  EXPECT_DOUBLE_EQ(patience.rest_speed(pair_of(0, 1)), tolerances.first_rest_speed);
  patience.begin_tick(touching);
  EXPECT_DOUBLE_EQ(patience.rest_speed(pair_of(0, 1)), tolerances.rest_speed);
  EXPECT_DOUBLE_EQ(patience.rest_speed(pair_of(0, 2)), tolerances.first_rest_speed);
  EXPECT_DOUBLE_EQ(patience.brief_slide(0), tolerances.brief_slide);
  patience.forget();
  patience.begin_tick(touching);
  EXPECT_DOUBLE_EQ(patience.rest_speed(pair_of(0, 1)), tolerances.first_rest_speed);
}

// A spinning robot meets the wall with one corner after the other: each is an impact of its own.
TEST(Patience, TouchesNowAndThenAreForgotten) {
  Patience patience = fresh();
  for (int i = 1; i <= 100; ++i) {
    patience.note_touch(pair_of(0, 1), 1.01 * tolerances.touch_forgotten * i);
    EXPECT_DOUBLE_EQ(patience.rest_speed(pair_of(0, 1)), tolerances.first_rest_speed) << i;
  }
}

// Or a body in a crowd would be followed as closely after each pause.
TEST(Patience, ManyTouchesAreNotForgotten) {
  Patience patience = fresh();
  for (int i = 0; i < tolerances.touches_never_forgotten; ++i) {
    patience.note_touch(pair_of(0, 1), 1e-3);
  }
  const double tired = patience.rest_speed(pair_of(0, 1));
  patience.note_touch(pair_of(0, 1), 1.0);
  EXPECT_GT(patience.rest_speed(pair_of(0, 1)), tired);
}

// Wheels that grip and slide again in turn throw a robot at the wall that it touches, without a new
// touch: that has to end, too. But what a touch brings about is not counted twice.
TEST(Patience, BouncesCountAsTouchesOnce) {
  Patience patience = fresh();
  patience.note_touch(pair_of(4, 5), 1e-3);
  for (int i = 0; i < 30; ++i) patience.note_bounce(pair_of(4, 5), 1e-3);
  EXPECT_DOUBLE_EQ(patience.rest_speed(pair_of(4, 5)), tolerances.first_rest_speed);
  for (int i = 0; i < 30; ++i) patience.note_bounce(pair_of(4, 5), 1e-3 + 1e-7 * i);
  EXPECT_GT(patience.rest_speed(pair_of(4, 5)), 1.0);
}

TEST(Patience, NeverLetsAPairSinkDeeperThanContactsReach) {
  Patience patience = fresh();
  for (int i = 0; i < 1000; ++i) patience.note_touch(pair_of(0, 1), 1e-3);
  EXPECT_DOUBLE_EQ(patience.sink(pair_of(0, 1)), tolerances.touch);
}

// Wheels are not stopped faster than anything else that rests.
TEST(Patience, StopsNoFasterSlideThanWhatRests) {
  Patience patience = fresh();
  for (int i = 0; i < 20; ++i) {
    EXPECT_LE(patience.brief_slide(1), patience.rest_speed(pair_of(0, 1)));
    patience.note_touch(pair_of(0, 1), 1e-3);
  }
}

// Contacts that would let go and press again at once are held for longer, until that ends.
TEST(Patience, HoldsLongerWhereItWasForced) {
  Patience patience = fresh();
  const double first = patience.hold();
  patience.note_event(crowd, false);
  const double calm = patience.hold() / first;
  patience.note_event(crowd, true);
  EXPECT_GT(patience.hold() / (first * calm), 2.0 * calm);
  for (int i = 0; i < 100; ++i) patience.note_event(crowd, true);
  EXPECT_LT(patience.hold(), 0.01);
}

// Wheels that grip and slide on at some speed would do so until the tick's events are used up.
TEST(Patience, StopsFasterSlidesTheLongerATickTakes) {
  Patience patience = fresh();
  for (int i = 0; i < 30; ++i) patience.note_event(crowd, false);
  EXPECT_LT(patience.rest_slide(), 2.0 * tolerances.rest_slide);
  for (int i = 0; i < 100; ++i) patience.note_event(crowd, false);
  EXPECT_GT(patience.rest_slide(), 20.0 * tolerances.rest_slide);
  for (int i = 0; i < 1000; ++i) patience.note_event(crowd, false);
  EXPECT_LE(patience.rest_slide(), tolerances.rest_speed);
}

// A curve is wanted longer the longer nothing has touched: or each would be as short as those of a
// burst that is over.
TEST(Patience, AsksForLongerCurvesAfterABurst) {
  Patience patience = fresh();
  EXPECT_EQ(patience.long_enough(1e-3), never);
  for (int i = 1; i <= 10; ++i) patience.note_touch(pair_of(0, 1), 1e-5 * i);
  EXPECT_LT(patience.long_enough(1e-4), 1e-4);
  EXPECT_GT(patience.long_enough(5e-3), 5e-3);
}

// Many events of a few are followed, few of many, and those of a crowd end nobody else's. Catches a
// budget that counts events alone: one of 22 robots costs far more than one of two.
TEST(Patience, FollowsFewerEventsOfMoreBodies) {
  const auto followed = [](const BodySet& bodies) {
    Patience patience = fresh();
    int events = 0;
    while (!(patience.exhausted() & bodies).any()) {
      patience.note_event(bodies, false);
      ++events;
    }
    EXPECT_TRUE((patience.exhausted() & ~bodies).none());
    return events;
  };
  EXPECT_EQ(followed(crowd), (tolerances.followed_per_tick + 80) / 81);
  EXPECT_EQ(followed(BodySet{0b1}), tolerances.followed_per_tick);
}

// Two that meet again and again are followed for longer than two of whom one has met others before. Catches
// a budget that sees only who is involved: in a crowd most events are of two.
TEST(Patience, FollowsWhoHasMetManyLessClosely) {
  const auto followed = [](int met) {
    Patience patience = fresh();
    for (int other = 2; other < 2 + met; ++other) patience.note_touch(pair_of(0, other), 1e-3);
    int events = 0;
    while (!patience.exhausted()[1]) {
      patience.note_touch(pair_of(0, 1), 2e-3);
      patience.note_event(bodies_of(pair_of(0, 1)), false);
      ++events;
    }
    return events;
  };
  EXPECT_EQ(followed(0), (tolerances.followed_per_tick + 15) / 16);
  EXPECT_EQ(followed(3), (tolerances.followed_per_tick + 99) / 100);
}

// Groups that were too much in a tick go in steps from the next one's begin while they are large, and
// concern no others. Catches one that waits for events, and one that does not let a row at rest be hit.
TEST(Patience, DoesNotFollowLargeGroupsAgain) {
  const BodySet four(0b1111);
  const BodySet five(0b1111100000);
  const BodySet at_rest(0b11111 << 10);
  Patience patience = fresh();
  for (int tick = 0; tick < 3; ++tick) {
    for (const BodySet& group : {four, five, at_rest}) patience.note_group(group);
    EXPECT_EQ(patience.exhausted(), tick == 0 ? BodySet() : five);
    for (int event = 0; event < 2; ++event) patience.note_event(four, false);
    if (tick == 0) patience.note_event(five, false);
    patience.begin_tick({});
  }
  patience.forget();
  patience.begin_tick({});
  patience.note_group(five);
  EXPECT_EQ(patience.exhausted(), BodySet());
}

TEST(Patience, IsFreshInEachTick) {
  Patience patience = fresh();
  for (int i = 0; i < 12; ++i) {
    patience.note_touch(pair_of(0, 1), 1e-3);
    patience.note_bounce(pair_of(0, 1), 2e-3);
    patience.note_event(crowd, true);
  }
  patience.begin_tick({});
  EXPECT_DOUBLE_EQ(patience.rest_speed(pair_of(0, 1)), tolerances.rest_speed);
  EXPECT_DOUBLE_EQ(patience.sink(pair_of(0, 1)), tolerances.sink);
  EXPECT_DOUBLE_EQ(patience.hold(), tolerances.hold);
}

}  // namespace
}  // namespace mirocup::simulator
