// SPDX-License-Identifier: MIT
//
// Catches a check that moves more robots than it must, such as one that goes through the robots one
// after the other and moves two because of one that stands between them; one that sends a robot to
// the other side of the field for a millimetre; and one that treats the two ends differently.
#include "core/base/random.hpp"
#include "core/referee/placement_check.hpp"
#include "core/referee/touches.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>

namespace mirocup::referee {
namespace {

struct Hall {
  explicit Hall(RobotLeague league = RobotLeague::small)
      : field(field::make_field(league)), rules(make_rules(Preset::mirosot)) {}

  Decision restart(Restart kind, End taker, const Vec2& spot = {0.0, 0.0}) const {
    Decision d;
    d.restart = kind;
    d.taker = taker;
    d.spot = default_placement(pitch, kind, taker, spot).ball;
    return d;
  }

  field::Field field;
  Rules rules;
  JudgedField pitch{field, rules, 0.02135, 0.075};
};

Pose at(double x, double y) {
  return {{x, y}, {1.0, 0.0}};
}

TEST(Placer, OneRobotBetweenTwoOthersIsMovedAlone) {
  const Hall hall;
  const Decision kick_off = hall.restart(Restart::KICK_OFF, End::left);
  Placement asked = default_placement(hall.pitch, Restart::KICK_OFF, End::left, {});
  asked.robots[0][0] = at(-0.4, 0.2);
  asked.robots[0][1] = at(-0.4, 0.14);
  asked.robots[0][2] = at(-0.4, 0.26);
  const CheckedPlacement granted = check_placement(hall.pitch, kick_off, Roles::any, asked);
  EXPECT_EQ(granted.moved[0].to_ulong(), 0b001u);
  EXPECT_EQ(granted.why[0][0], Misplaced::too_near_robot);
  EXPECT_TRUE(granted.moved[1].none());
}

TEST(Placer, ARobotThatIsMovedAnywayTakesTheSpecialPlace) {
  const Hall hall;
  const Decision penalty = hall.restart(Restart::PENALTY_KICK, End::left);
  Placement asked = default_placement(hall.pitch, Restart::PENALTY_KICK, End::left, {});
  asked.robots[0][1] = at(-0.2, -0.2);  // the kicker stays in its half, which is allowed
  asked.robots[0][2] = at(0.5, 0.3);    // this one has left it
  const CheckedPlacement granted = check_placement(hall.pitch, penalty, Roles::any, asked);
  EXPECT_EQ(granted.moved[0].to_ulong(), 0b100u);
  EXPECT_LT(granted.placement.robots[0][2].position.x(), granted.placement.ball.x());
  EXPECT_GT(granted.placement.robots[0][2].position.x(), 0.0) << "it is the kicker now";

  asked.robots[0][2] = at(-0.2, 0.3);  // all in their half: the nearest one has to go
  const CheckedPlacement sent = check_placement(hall.pitch, penalty, Roles::any, asked);
  EXPECT_EQ(sent.moved[0].count(), 1u);
  EXPECT_FALSE(sent.moved[0][0]) << "the keeper is farthest from the ball";
}

TEST(Placer, OneOfThreeInTheOtherGoalAreaStays) {
  const Hall hall;
  const Decision goal_kick = hall.restart(Restart::GOAL_KICK, End::left);
  Placement asked = default_placement(hall.pitch, Restart::GOAL_KICK, End::left, {});
  asked.robots[0][1] = at(0.69, 0.15);
  asked.robots[0][2] = at(0.69, -0.15);
  const CheckedPlacement granted = check_placement(hall.pitch, goal_kick, Roles::any, asked);
  EXPECT_EQ(granted.moved[0].count(), 1u);
  EXPECT_EQ(granted.why[0][granted.moved[0][1] ? 1 : 2], Misplaced::second_in_goal_area);
}

TEST(Placer, ARobotGoesToTheNearestPlaceAndKeepsItsHeading) {
  const Hall hall;
  const Decision kick_off = hall.restart(Restart::KICK_OFF, End::right);
  Placement asked = default_placement(hall.pitch, Restart::KICK_OFF, End::right, {});
  asked.robots[0][2] = {{-0.03, 0.5}, {0.0, 1.0}};  // 7.5 mm over the half line
  const CheckedPlacement granted = check_placement(hall.pitch, kick_off, Roles::any, asked);
  ASSERT_EQ(granted.moved[0].to_ulong(), 0b100u);
  const Pose& pose = granted.placement.robots[0][2];
  EXPECT_LT((pose.position - asked.robots[0][2].position).norm(), 0.0126);
  EXPECT_EQ(pose.heading.sin, 1.0);
}

TEST(Placer, ARobotThatIsMovedMakesNoOtherTeamMove) {
  const Hall hall;
  const Decision kick_off = hall.restart(Restart::KICK_OFF, End::left);
  Placement asked = default_placement(hall.pitch, Restart::KICK_OFF, End::left, {});
  asked.robots[0][2] = at(0.3, 0.0);  // where an opponent stands, and not allowed
  const CheckedPlacement granted = check_turn(hall.pitch, kick_off, End::left, Roles::any, asked);
  EXPECT_EQ(granted.moved[0].to_ulong(), 0b100u);
  EXPECT_TRUE(granted.moved[1].none());
}

// What the law says about a set of robots of the team that is checked first, from the same
// predicates, but with none of the code that searches.
bool may_stay(const Hall& hall, const PlacementRules& rules, End team, const Placement& asked,
              unsigned kept) {
  const auto& poses = asked.robots[index_of(team)];
  const int n = hall.field.robots_per_team;
  int in_special = 0;
  int in_other_area = 0;
  for (int i = 0; i < n; ++i) {
    if (!((kept >> i) & 1u)) continue;
    const Pose& pose = poses[i];
    if (!is_inside_walls(hall.pitch, pose)) return false;
    if (ball_gap(hall.pitch, rules.ball, pose) <= 0.0) return false;
    const bool special = has_special_place(rules, team, pose);
    const bool keeps = rules.restart == Restart::FREE_BALL && i == keeper &&
                       hall.field.inside(hall.field.goal_area, team, pose.position);
    if (!special && !keeps && !may_stand(rules, team, pose)) return false;
    in_special += special;
    in_other_area += rules.restart == Restart::GOAL_KICK && team == rules.taker &&
                     hall.field.inside(hall.field.goal_area, opposite(team), pose.position);
    for (int j = 0; j < i; ++j) {
      if (!((kept >> j) & 1u)) continue;
      if (robot_gap(hall.pitch, pose, poses[j], 0.004) < 0.004) return false;
    }
  }
  const bool all = kept == (1u << n) - 1u;
  const bool needed = holder_of_special_place(rules, team) >= 0;
  return in_special <= 1 && in_other_area <= 1 && !(needed && all && in_special == 0);
}

Placement turned(Placement p) {
  p.ball = -p.ball;
  std::swap(p.robots[0], p.robots[1]);
  for (auto& team : p.robots) {
    for (Pose& pose : team) pose = {-pose.position, pose.heading.half_turned()};
  }
  return p;
}

// Wild requests: the number of robots that are moved is the least, nobody stands in anybody, and
// the field turned by half a turn gives every number negated.
TEST(Placer, MovesAsFewAsPossibleForBothEnds) {
  Random random(28);
  int moved = 0;
  for (const RobotLeague league : {RobotLeague::small, RobotLeague::middle}) {
    const Hall hall(league);
    for (int round = 0; round < 150; ++round) {
      const Restart kind = std::array{Restart::KICK_OFF, Restart::PENALTY_KICK, Restart::FREE_KICK,
                                      Restart::GOAL_KICK, Restart::FREE_BALL}[random.below(5)];
      const Vec2 mark = hall.field.free_ball_mark;
      const End taker = kind == Restart::FREE_BALL ? End::right : End::left;
      const Decision restart = hall.restart(kind, taker, mark);
      const Placement defaults = default_placement(hall.pitch, kind, taker, mark);
      const End first = first_placer(kind, taker);
      Placement asked = defaults;
      for (int i = 0; i < hall.field.robots_per_team; ++i) {
        Pose& pose = asked.robots[index_of(first)][i];
        if (random.below(4) == 0) continue;
        const Vec2 centre{random.below(2) == 0 ? 0.0 : 0.9 * attack_sign(first), 0.0};
        const double size = random.below(2) == 0 ? 0.2 : hall.field.half_length;
        pose.position = -centre * hall.field.half_length +
                        Vec2{random.uniform(-size, size), random.uniform(-size, size)};
      }
      const CheckedPlacement granted = check_turn(hall.pitch, restart, first, Roles::any, asked);
      const PlacementRules rules{.pitch = hall.pitch,
                                 .restart = kind,
                                 .taker = taker,
                                 .roles = Roles::any,
                                 .defaults = defaults,
                                 .ball = restart.spot};
      int most = 0;
      for (unsigned kept = 0; kept < 1u << hall.field.robots_per_team; ++kept) {
        if (may_stay(hall, rules, first, asked, kept)) most = std::max(most, std::popcount(kept));
      }
      const int count = static_cast<int>(granted.moved[index_of(first)].count());
      const int kept = hall.field.robots_per_team - count;
      // At a free kick a keeper that may stay has to make way for its own wall.
      ASSERT_LE(kept, most) << to_string(kind) << " " << round;
      if (kind != Restart::FREE_KICK) {
        ASSERT_EQ(kept, most) << to_string(kind) << " " << round;
      }
      moved += count;
      const auto wrong = misplaced_robots(hall.pitch, restart, Roles::any, granted.placement);
      ASSERT_TRUE(wrong[0].none() && wrong[1].none()) << to_string(kind) << " " << round;

      Decision other = restart;
      other.taker = opposite(taker);
      other.spot = -restart.spot;
      const CheckedPlacement mirrored =
          check_turn(hall.pitch, other, opposite(first), Roles::any, turned(asked));
      const Placement back = turned(mirrored.placement);
      for (int e = 0; e < 2; ++e) {
        EXPECT_EQ(mirrored.moved[1 - e], granted.moved[e]);
        for (int i = 0; i < hall.field.robots_per_team; ++i) {
          ASSERT_EQ(back.robots[e][i].position, granted.placement.robots[e][i].position);
          ASSERT_EQ(back.robots[e][i].heading.cos, granted.placement.robots[e][i].heading.cos);
        }
      }
    }
  }
  EXPECT_GT(moved, 300);
}

}  // namespace
}  // namespace mirocup::referee
