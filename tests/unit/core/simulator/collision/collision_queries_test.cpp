// SPDX-License-Identifier: MIT
//
// Questions about pairs of all kinds: with a body, an end wall, a plane wall.
#include "core/simulator/collision/collision_queries.hpp"

#include <gtest/gtest.h>

#include <array>
#include <memory>

namespace mirocup::simulator::collision {
namespace {

// The ball rolls round a robot's corner. Catches a ball that is still held off the corner when the
// edge is nearer.
TEST(RefreshContact, BallRoundACornerTouchesTheEdge) {
  const StaticWorld world = make_static_world(nullptr, Parameters{}, Tolerances{}, 1, true);
  const double half = 0.5 * world.parameters.robot_side;
  const double radius = world.parameters.ball_radius;
  std::array<BodyState, 2> bodies{BodyState{{0.0, 0.0}, Heading{}, {}}, BodyState{}};
  const Pair pair = pair_of(1, 0);
  const auto list = std::make_unique<ContactList>();
  for (const double end : {1.0, -1.0}) {
    bodies[1].position = {end * (half + 0.6 * radius), end * (half + 0.8 * radius)};
    list->count = 0;
    add_contacts(world, pair, bodies, 1e-3, *list);
    ASSERT_EQ(list->count, 1);
    ASSERT_EQ(list->list[0].point.kind, Touching::circle_on_corner);
    bodies[1].position = {end * (half - 0.001), end * (half + radius - 1e-6)};
    refresh_contact(world, bodies, pair, list->list[0].point);
    EXPECT_EQ(list->list[0].point.kind, Touching::circle_on_edge);
    EXPECT_NEAR(list->list[0].point.gap, -1e-6, 1e-15);
  }
}

// A robot's corner leaves the edge of another robot sideways: behind the edge's line there is then
// nothing. Catches a depth of 10 mm where the bodies are apart.
TEST(ClampedGap, CornerBesideTheEdgeDoesNotPenetrate) {
  const StaticWorld world = make_static_world(nullptr, Parameters{}, Tolerances{}, 2, false);
  const double side = world.parameters.robot_side;
  std::array<BodyState, 2> bodies{BodyState{}, BodyState{{side + 1e-5, 0.5 * side}, Heading{}, {}}};
  const auto list = std::make_unique<ContactList>();
  add_contacts(world, pair_of(0, 1), bodies, 1e-3, *list);
  ASSERT_GT(list->count, 0);
  const Contact& contact = list->list[0];
  EXPECT_NEAR(clamped_gap(world, bodies, contact, 1e-6), 1e-5, 1e-15);

  bodies[1].position = {side - 0.01, side + 1e-4};
  ContactPoint on_line = contact.point;
  refresh_contact(world, bodies, pair_of(0, 1), on_line);
  EXPECT_NEAR(on_line.gap, -0.01, 1e-12);
  EXPECT_NEAR(clamped_gap(world, bodies, contact, 1e-6), 1e-4, 1e-12);
}

// A robot drives at 1 m/s against each kind of obstacle. Catches an obstacle that is taken for
// another one, and one at which time stands still.
TEST(ContactTime, IsTheDistanceDividedByTheSpeed) {
  const field::Field field = field::make_field(RobotLeague::small);
  const StaticWorld world = make_static_world(&field, Parameters{}, Tolerances{}, 1, false);
  constexpr double distance = 0.01;  // m
  const double half = 0.5 * world.parameters.robot_side;
  const auto expect_contact = [&](const Pair& pair, const Vec2& normal, const Vec2& on_face) {
    const Heading heading{-normal.x(), -normal.y()};
    const BodyState body{on_face + (half + distance) * normal, heading, {1.0, 0.0, 0.0}};
    const std::array segments{trajectory::steady_segment(body, 0.0, 0.033)};
    EXPECT_NEAR(contact_time(world, pair, segments, 0.0, 1e-12), distance, 1e-12) << pair.partner;
    EXPECT_NEAR(first_time_below(world, pair, -1e-3, segments, 0.0), distance + 1e-3, 1e-12);
    const std::array short_of{trajectory::steady_segment(body, 0.0, 0.009)};
    EXPECT_EQ(contact_time(world, pair, short_of, 0.0, 1e-12), trajectory::never);
  };
  for (int k = 0; k < plane_walls; ++k) {
    const field::Wall& wall = field.walls[k];
    expect_contact(pair_with_obstacle(0, k), wall.normal, wall.offset * wall.normal);
  }
  for (int k = 0; k < end_walls; ++k) {
    const field::GoalPost& post = field.posts[k];
    expect_contact(pair_with_obstacle(0, plane_walls + k), post.face, post.post - 0.1 * post.side);
  }
}

// Catches coefficients that are mixed up between the kinds of pairs.
TEST(StaticWorld, EachKindOfPairHasItsOwnRestitution) {
  Parameters p;
  p.restitution = {.ball_wall = 0.1, .ball_robot = 0.2, .robot_wall = 0.3, .robot_robot = 0.4};
  const field::Field field = field::make_field(RobotLeague::small);
  const StaticWorld world = make_static_world(&field, p, Tolerances{}, 2, true);
  EXPECT_EQ(restitution(world, pair_with_obstacle(2, 0)), 0.1);
  EXPECT_EQ(restitution(world, pair_of(0, 2)), 0.2);
  EXPECT_EQ(restitution(world, pair_with_obstacle(1, plane_walls)), 0.3);
  EXPECT_EQ(restitution(world, pair_of(0, 1)), 0.4);
}

}  // namespace
}  // namespace mirocup::simulator::collision
