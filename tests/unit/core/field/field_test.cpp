// SPDX-License-Identifier: MIT
//
// Catches a wrong dimension, an arc on the wrong side, walls that break the half-turn symmetry.
#include "core/field/field.hpp"

#include <gtest/gtest.h>

namespace mirocup::field {
namespace {

class EveryField : public testing::TestWithParam<RobotLeague> {};
INSTANTIATE_TEST_SUITE_P(Leagues, EveryField,
                         testing::Values(RobotLeague::small, RobotLeague::middle,
                                         RobotLeague::large),
                         [](const auto& league) { return std::string(to_string(league.param)); });

TEST_P(EveryField, IsSymmetricUnderAHalfTurn) {
  const Field f = make_field(GetParam());
  for (std::size_t i = 0; i < f.walls.size(); i += 2) {
    EXPECT_EQ(f.walls[i].normal, -f.walls[i + 1].normal);
    EXPECT_EQ(f.walls[i].offset, f.walls[i + 1].offset);
  }
  for (std::size_t i = 0; i < f.posts.size(); i += 2) {
    EXPECT_EQ(f.posts[i].post, -f.posts[i + 1].post);
    EXPECT_EQ(f.posts[i].face, -f.posts[i + 1].face);
    EXPECT_EQ(f.posts[i].side, -f.posts[i + 1].side);
  }
}

TEST_P(EveryField, ClearanceIsTheDistanceToTheNearestSolid) {
  const Field f = make_field(GetParam());
  const double x = f.half_length;
  const double y = f.half_width;
  EXPECT_NEAR(f.clearance({0.0, y - 0.01}), 0.01, 1e-12);
  EXPECT_NEAR(f.clearance({-x + 0.02, 0.5 * (y + f.goal_half_width)}), 0.02, 1e-12);
  EXPECT_NEAR(f.clearance({x + f.goal_depth - 0.03, 0.0}), 0.03, 1e-12) << "in the goal";
  EXPECT_LT(f.clearance({x + 0.01, f.goal_half_width + 0.01}), 0.0) << "behind the goal line";
  EXPECT_LT(f.clearance({x - 0.03, y - 0.03}), 0.0) << "in the corner triangle";
  EXPECT_NEAR(f.clearance({x - 0.03, f.goal_half_width}), 0.03, 1e-12) << "before a post";
}

TEST(SmallField, HasTheArcOfTheRuleBook) {
  const Field f = make_field(RobotLeague::small);
  EXPECT_NEAR(f.goal_area.arc_radius, 0.125, 1e-12);
  EXPECT_NEAR(f.goal_area.arc_centre, 0.675, 1e-12);
  EXPECT_TRUE(f.inside(f.goal_area, End::right, {0.551, 0.0}));
  EXPECT_FALSE(f.inside(f.goal_area, End::right, {0.549, 0.0}));
  EXPECT_FALSE(f.inside(f.goal_area, End::right, {0.599, 0.11})) << "beside the arc";
  EXPECT_TRUE(f.inside(f.goal_area, End::right, {0.60, 0.35})) << "lines belong to the area";
  EXPECT_FALSE(f.inside(f.goal_area, End::right, {0.61, 0.36}));
  EXPECT_TRUE(f.inside(f.goal_area, End::right, {0.80, 0.19})) << "the goal belongs to it";
  EXPECT_FALSE(f.inside(f.goal_area, End::left, {0.70, 0.0}));
  EXPECT_TRUE(f.inside(f.goal_area, End::left, {-0.70, 0.0}));
}

TEST(LargerFields, HaveTheArcsOfTheRuleBook) {
  const Field middle = make_field(RobotLeague::middle);
  EXPECT_NEAR(middle.penalty_area->arc_radius, 0.18125, 1e-12);
  EXPECT_NEAR(middle.penalty_area->arc_centre, 0.88125, 1e-12);
  const Field large = make_field(RobotLeague::large);
  EXPECT_NEAR(large.penalty_area->arc_radius, 0.30, 1e-6);
  EXPECT_NEAR(large.penalty_area->arc_centre, 1.50, 1e-6);
}

TEST(TeamFrame, IsAHalfTurnForTheRightEndAndItsOwnInverse) {
  const Pose pose{{0.3, -0.2}, Heading::from_angle(0.7)};
  const Pose seen = team_frame(End::right, pose);
  EXPECT_EQ(seen.position, (Vec2{-0.3, 0.2}));
  EXPECT_NEAR(seen.heading.angle(), 0.7 - pi, 1e-15);
  EXPECT_EQ(team_frame(End::right, seen).position, pose.position);
  EXPECT_EQ(team_frame(End::left, pose).position, pose.position);
}

}  // namespace
}  // namespace mirocup::field
