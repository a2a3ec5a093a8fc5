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

constexpr int all_bodies = 7;
constexpr double tick = 0.033;

// Returns how many events that cost so much use up the budget of a world of so many bodies.
int events_in_budget(int cost, int bodies = all_bodies) {
  return (bodies * tolerances.event_budget + cost - 1) / cost;
}

RestThresholds fresh(int bodies = all_bodies) {
  RestThresholds thresholds(tolerances, bodies);
  thresholds.begin_tick(tick);
  return thresholds;
}

// A contact of a corner on an edge, with restitution e, for which an impulse of 1 N s changes the
// rate of the gap by 2 m/s.
constexpr double restitution = 0.3;
constexpr double inverse_mass = 2.0;
const std::array<solver::InverseMass, max_bodies> masses = [] {
  std::array<solver::InverseMass, max_bodies> all;
  all.fill({inverse_mass, inverse_mass, 0.0});
  return all;
}();

collision::Contact contact_of(const Pair& pair, int corner = 0, double e = restitution) {
  collision::Contact c;
  c.pair = pair;
  c.a = pair.a;
  c.point.corner = corner;
  c.row = {.a = pair.a, .b = no_body, .on_a = {1.0, 0.0, 0.0}, .on_b = {}};
  c.material.restitution = e;
  return c;
}

// Notes an impact of the contact at time t, with this approach.
void hit(RestThresholds& thresholds, collision::Contact contact, double approach, double t) {
  contact.impact.approach = approach;
  contact.impact.impulse = approach;
  thresholds.note_contact(contact, masses, t);
}

// Returns the longest flight after which an approach ends a series.
double longest_flight(double approach, double e) {
  return 4.0 * tolerances.series_height * (1.0 - e) / (e * e * approach);
}

// However slow: slow rebounds and approaches would be wrong by the threshold otherwise.
TEST(RestThresholds, AFirstImpactBounces) {
  EXPECT_DOUBLE_EQ(fresh().restitution_threshold(contact_of(pair_of(0, 1)), 1e-3),
                   tolerances.first_touch_threshold);
}

// Catches thresholds that count the impacts of a body: another corner, and another body that hits
// one of the two, must bounce however often the pair did.
TEST(RestThresholds, KnowOneContactFromAnother) {
  RestThresholds thresholds = fresh();
  for (int i = 1; i <= 50; ++i) hit(thresholds, contact_of(pair_of(0, 1)), 0.1, 1e-6 * i);
  for (const collision::Contact& other :
       {contact_of(pair_of(0, 1), 1), contact_of(pair_of(0, 2)), contact_of(pair_of(1, 2)),
        contact_of(pair_with_obstacle(1, 3))}) {
    EXPECT_DOUBLE_EQ(thresholds.restitution_threshold(other, 51e-6),
                     tolerances.first_touch_threshold);
  }
}

// Catches a threshold that drops a fast approach because slow ones came before.
TEST(RestThresholds, AFasterApproachIsANewHit) {
  RestThresholds thresholds = fresh();
  const collision::Contact contact = contact_of(pair_of(0, 1));
  hit(thresholds, contact, 1e-3, 1e-3);
  const double soon = 1e-3 + 0.1 * longest_flight(1e-3, restitution);
  EXPECT_GE(thresholds.restitution_threshold(contact, soon), restitution * 1e-3);
  EXPECT_LT(thresholds.restitution_threshold(contact, soon), 1e-3);
}

// Catches a series that ends while its bounces are higher than the tolerance says.
TEST(RestThresholds, ASeriesEndsWhereItsBouncesAreLow) {
  RestThresholds thresholds = fresh();
  const collision::Contact contact = contact_of(pair_of(0, 1));
  hit(thresholds, contact, 0.02, 0.0);
  const double approach = restitution * 0.02;
  const double limit = longest_flight(approach, restitution);
  EXPECT_GE(thresholds.restitution_threshold(contact, 0.99 * limit), approach);
  EXPECT_LT(thresholds.restitution_threshold(contact, 1.01 * limit), approach);
}

// A contact that a third body closes again at once comes back faster than any motor drives it.
// Catches such a hit that is taken for a bounce of the series, and lost.
TEST(RestThresholds, AHitRightAfterAnotherIsNoSeries) {
  RestThresholds thresholds = fresh();
  const collision::Contact contact = contact_of(pair_of(0, 1));
  hit(thresholds, contact, 1.0, 0.0);
  EXPECT_LT(thresholds.restitution_threshold(contact, 1e-6), 0.1 * restitution);
}

// Energy must be kept at e = 1, however fast impacts follow each other.
TEST(RestThresholds, ElasticContactsAlwaysBounce) {
  RestThresholds thresholds = fresh();
  const collision::Contact contact = contact_of(pair_of(0, 1), 0, 1.0);
  for (const double t : {0.0, 1e-15, 1e-6}) {
    EXPECT_DOUBLE_EQ(thresholds.restitution_threshold(contact, t),
                     tolerances.first_touch_threshold);
    hit(thresholds, contact, 0.5, t);
    EXPECT_DOUBLE_EQ(thresholds.restitution_threshold(contact, t),
                     tolerances.first_touch_threshold);
  }
}

// A contact that presses with a known acceleration would bounce to a known height.
TEST(RestThresholds, APressingContactRestsBelowTheSameHeight) {
  RestThresholds thresholds = fresh();
  collision::Contact contact = contact_of(pair_of(0, 1));
  contact.resting = {.is_active = true, .is_persistent = true, .force = 100.0};
  thresholds.note_contact(contact, masses, 0.0);
  const double speed = restitution * thresholds.restitution_threshold(contact, 1e-3);
  EXPECT_NEAR(speed * speed / (2.0 * 100.0 * inverse_mass),
              (1.0 - restitution) * tolerances.series_height, 1e-12);
  contact.resting.force = 1e-6;
  thresholds.note_contact(contact, masses, 0.0);
  EXPECT_DOUBLE_EQ(thresholds.restitution_threshold(contact, 1e-3), tolerances.pressing_threshold);
}

// Catches a memory that depends on the ticks in which the time was played, and one that is not part
// of what a tick leaves.
TEST(RestThresholds, DoNotDependOnTheLengthOfTicks) {
  const collision::Contact contact = contact_of(pair_of(0, 1));
  const double flight = 2e-3;
  RestThresholds one = fresh();
  RestThresholds many = fresh();
  hit(one, contact, 0.01, 1e-3);
  hit(many, contact, 0.01, 1e-3);
  many.end_tick(1.5e-3);
  RestThresholds copy = fresh();
  copy.recall(many.memory());
  copy.begin_tick(tick);
  copy.end_tick(1.0e-3);
  copy.begin_tick(tick);
  EXPECT_NEAR(copy.restitution_threshold(contact, flight - 1.5e-3) /
                  one.restitution_threshold(contact, 1e-3 + flight),
              1.0, 1e-9);
}

// A contact that was left long ago, and one between bodies that were placed, is a new one. Catches
// contacts that are forgotten at a tick's end, when World::save() still needs them.
TEST(RestThresholds, ContactsAreForgotten) {
  const collision::Contact contact = contact_of(pair_of(0, 1));
  RestThresholds thresholds = fresh();
  hit(thresholds, contact, 0.01, 0.0);
  EXPECT_TRUE(thresholds.remembers(contact));
  thresholds.end_tick(1.0);
  EXPECT_TRUE(thresholds.remembers(contact));
  thresholds.begin_tick(tick);
  EXPECT_FALSE(thresholds.remembers(contact));
  hit(thresholds, contact, 0.01, 0.0);
  thresholds.forget();
  EXPECT_FALSE(thresholds.remembers(contact));
}

// Contacts that would let go and press again at once are held for longer, until that ends. Catches
// a duration that grows with other events.
TEST(RestThresholds, MinDurationGrowsWhereItForcedAnEnd) {
  RestThresholds thresholds = fresh();
  const double first = thresholds.min_duration();
  thresholds.note_event(crowd, false);
  EXPECT_DOUBLE_EQ(thresholds.min_duration(), first);
  thresholds.note_event(crowd, true);
  EXPECT_GT(thresholds.min_duration(), 2.0 * first);
  for (int i = 0; i < 100; ++i) thresholds.note_event(crowd, true);
  EXPECT_LT(thresholds.min_duration(), 0.01);
}

// The longer nothing has collided, the longer a curve may be. Otherwise each would be as short as
// those of a burst that is over.
TEST(RestThresholds, CurvesMayBeLongerAfterABurst) {
  RestThresholds thresholds = fresh();
  EXPECT_EQ(thresholds.preferred_duration(1e-3), trajectory::never);
  for (int i = 1; i <= 10; ++i) thresholds.note_impact(1e-5 * i);
  EXPECT_LT(thresholds.preferred_duration(1e-4), 1e-4);
  EXPECT_GT(thresholds.preferred_duration(5e-3), 5e-3);
}

// Catches a budget that counts events alone, since one of 22 robots costs far more than one of two;
// one in which 280 events of two bodies fit into a tick, or two of 22 robots, which take 5 ms
// each; one that ends the bounces of a ball between a wall and a robot alone; and one that steps
// bodies to which nothing happens any more.
TEST(RestThresholds, AnEventOfMoreBodiesCostsMore) {
  const auto followed = [](const BodySet& bodies, int all) {
    RestThresholds thresholds = fresh(all);
    int events = 0;
    for (; thresholds.over_budget().none(); ++events) thresholds.note_event(bodies, false);
    EXPECT_EQ(thresholds.over_budget(), bodies);
    return events;
  };
  EXPECT_EQ(followed(crowd, all_bodies), events_in_budget(9));
  EXPECT_EQ(followed(BodySet{0b1}, all_bodies), events_in_budget(1));
  EXPECT_EQ(followed(BodySet{0b11}, all_bodies), events_in_budget(6));
  EXPECT_EQ(followed(BodySet{0b11}, 2), events_in_budget(2));
  EXPECT_EQ(followed(BodySet{0x7ff}, max_bodies), events_in_budget(146, max_bodies));
  EXPECT_EQ(followed(BodySet{0x3fffff}, max_bodies), 1);
}

// Catches a budget that does not depend on the tick's length: in a tick of 1 s more than a hundred
// bounces are usual, and bodies that are time-stepped do not keep their energy.
TEST(RestThresholds, ALongTickHasMoreBudget) {
  RestThresholds thresholds = fresh();
  thresholds.begin_tick(1.0);
  for (int i = 0; i < 2500; ++i) thresholds.note_event(BodySet{0b11}, false);
  EXPECT_TRUE(thresholds.over_budget().none());
}

// A large island that went over budget is over budget from the start of the next tick, and no other
// island is. A small one then has less to spend. Catches a budget that waits for events, one that
// steps a row at rest, and a scrum that spends a whole budget in each tick before it is stepped.
TEST(RestThresholds, AnIslandThatWentOverBudgetHasLess) {
  const BodySet four(0b1111);
  const BodySet five(0b111110000);
  const BodySet at_rest(0b11111 << 9);
  RestThresholds thresholds = fresh();
  const int whole = events_in_budget(16);
  const int few = whole / settings::rest_thresholds.budget_divisor + 1;
  for (int k = 0; k < 3; ++k) {
    for (const BodySet& island : {four, five, at_rest}) thresholds.note_island(island);
    EXPECT_EQ(thresholds.over_budget(), k == 0 ? BodySet() : five);
    int events = 0;
    for (; !thresholds.over_budget()[0]; ++events) thresholds.note_event(four, false);
    EXPECT_EQ(events, k == 0 ? whole : few);
    while (!thresholds.over_budget()[4]) thresholds.note_event(five, false);
    thresholds.begin_tick(tick);
  }
  thresholds.forget();
  thresholds.begin_tick(tick);
  thresholds.note_island(five);
  EXPECT_EQ(thresholds.over_budget(), BodySet());
}

TEST(RestThresholds, EachTickStartsAfresh) {
  RestThresholds thresholds = fresh();
  for (int i = 0; i < 12; ++i) thresholds.note_event(crowd, true);
  thresholds.begin_tick(tick);
  EXPECT_DOUBLE_EQ(thresholds.min_duration(), tolerances.min_contact_duration);
}

}  // namespace
}  // namespace mirocup::simulator::impact
