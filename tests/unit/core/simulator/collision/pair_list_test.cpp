// SPDX-License-Identifier: MIT
//
// Broad phase and pair list: no pair that touches may be missing, and none may be there twice.
#include "core/simulator/collision/pair_list.hpp"

#include "core/base/random.hpp"
#include "core/simulator/collision/broad_phase.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <set>
#include <utility>
#include <vector>

namespace mirocup::simulator::collision {
namespace {

using PairSet = std::set<std::pair<int, int>>;

struct Crowd {
  field::Field field = field::make_field(RobotLeague::small);
  StaticWorld world = make_static_world(&field, Parameters{}, Tolerances{}, max_robots, true);
  std::vector<BodyState> bodies = std::vector<BodyState>(max_bodies);
  std::vector<trajectory::Box> boxes = std::vector<trajectory::Box>(max_bodies);
  std::unique_ptr<PairList> pairs = std::make_unique<PairList>();

  // Bodies may overlap each other, but are not deep in a side wall: the broad phase relies on that.
  void place(Random& random, int i) {
    const double max_y = field.half_width - 0.5 * world.parameters.robot_side;
    const Vec2 p{random.uniform(-field.half_length, field.half_length),
                 random.uniform(-max_y, max_y)};
    bodies[i].position = p;
    bodies[i].heading = Heading::from_angle(random.uniform(-pi, pi));
    boxes[i] = {p.x(), p.x(), p.y(), p.y()};
  }

  PairSet listed() const {
    PairSet found;
    for (const CandidatePair& n : std::as_const(*pairs).list()) {
      EXPECT_TRUE(found.emplace(n.pair.a, n.pair.partner).second) << "a pair is there twice";
    }
    return found;
  }

  PairSet touching() const {
    PairSet found;
    for (int i = 0; i < world.bodies(); ++i) {
      for (int j = 0; j < i; ++j) add_if_touching(pair_of(i, j), found);
      for (int k = 0; k < plane_walls + end_walls; ++k) {
        add_if_touching(pair_with_obstacle(i, k), found);
      }
    }
    return found;
  }

  void add_if_touching(const Pair& pair, PairSet& found) const {
    if (gap(world, pair, bodies) <= world.tolerances.contact_gap) {
      found.emplace(pair.a, pair.partner);
    }
  }
};

// Catches a box test with the wrong sign or reach, and an obstacle that is asked for too late.
TEST(PairList, HoldsEveryPairThatTouches) {
  Random random(3);
  Crowd crowd;
  std::size_t touching = 0;
  for (int round = 0; round < 300; ++round) {
    for (int i = 0; i < max_bodies; ++i) crowd.place(random, i);
    crowd.pairs->find(crowd.world, crowd.boxes, ~BodySet{});
    const PairSet listed = crowd.listed();
    const PairSet expected = crowd.touching();
    touching += expected.size();
    EXPECT_TRUE(std::includes(listed.begin(), listed.end(), expected.begin(), expected.end()));
  }
  EXPECT_GT(touching, 1000U);
}

// Catches pairs of unchanged bodies that are lost, and pairs of changed ones that stay.
TEST(PairList, AnUpdateGivesTheSameAsANewList) {
  Random random(4);
  Crowd crowd;
  for (int i = 0; i < max_bodies; ++i) crowd.place(random, i);
  crowd.pairs->find(crowd.world, crowd.boxes, ~BodySet{});
  for (int round = 0; round < 100; ++round) {
    BodySet changed;
    for (int k = 0; k < 3; ++k) changed.set(random.below(max_bodies));
    for_each_body(changed, [&](int i) { crowd.place(random, i); });
    crowd.pairs->find(crowd.world, crowd.boxes, changed);
    const PairSet updated = crowd.listed();
    crowd.pairs->find(crowd.world, crowd.boxes, ~BodySet{});
    ASSERT_EQ(updated, crowd.listed()) << round;
  }
}

// The capacity is the number of pairs there are. Catches a formula that forgets some.
TEST(PairList, HasRoomForAllPairs) {
  Crowd crowd;
  const double all = 10.0;  // m, larger than the field
  for (trajectory::Box& box : crowd.boxes) box = {-all, all, -all, all};
  const auto found = crowd.pairs->find(crowd.world, crowd.boxes, ~BodySet{});
  EXPECT_EQ(static_cast<int>(found.size()), max_candidate_pairs);
}

// Catches an order that depends on the order of the list: both ends of the field would differ.
TEST(PairList, EarliestPairIsThatOfTheLowestBodies) {
  Crowd crowd;
  for (int i = 0; i < 4; ++i) crowd.boxes[i] = {0.0, 0.0, 0.0, 0.0};
  crowd.world.field = nullptr;
  crowd.world.robots = 3;
  for (CandidatePair& n : crowd.pairs->find(crowd.world, crowd.boxes, ~BodySet{})) {
    n.contact_time = n.pair == pair_of(1, 0) ? 0.02 : 0.01;
  }
  double t = 0.033;
  const CandidatePair* first = crowd.pairs->earliest(t);
  ASSERT_NE(first, nullptr);
  EXPECT_EQ(first->pair, pair_of(2, 0));
  EXPECT_EQ(t, 0.01);
  t = 0.005;
  EXPECT_EQ(crowd.pairs->earliest(t), nullptr);
  EXPECT_EQ(t, 0.005);
}

}  // namespace
}  // namespace mirocup::simulator::collision
