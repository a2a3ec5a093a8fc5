// SPDX-License-Identifier: MIT
//
// Catches bodies that are put down exactly, too far off, where the law forbids it, or anew although
// nobody touched them.
#include "core/match/put_down.hpp"

#include "core/match/leg.hpp"
#include "tests/support/controllers.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace mirocup::match {
namespace {

using test_support::short_setup;

constexpr referee::Restart restarts[] = {referee::Restart::KICK_OFF, referee::Restart::GOAL_KICK,
                                         referee::Restart::PENALTY_KICK,
                                         referee::Restart::FREE_BALL, referee::Restart::FREE_KICK};

// Returns the greater distance along an axis, m.
double farther_axis(const Vec2& off) {
  return std::max(std::abs(off.x()), std::abs(off.y()));
}

TEST(PutDown, EveryBodyIsALittleOffAndStandsLegally) {
  const Conditions hall = conditions_of(ConditionsPreset::hall);
  for (const RobotLeague league : {RobotLeague::small, RobotLeague::middle, RobotLeague::large}) {
    const Leg leg(short_setup(1, 3.0, league));
    const referee::JudgedField& pitch = leg.pitch();
    const int robots = pitch.field.robots_per_team;
    int exact = 0, all = 0;
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
      Disturbances disturbances(hall, seed, robots);
      for (const referee::Restart kind : restarts) {
        referee::Decision restart;
        restart.restart = kind;
        restart.taker = seed % 2 == 0 ? End::left : End::right;
        restart.spot = {0.2, 0.2};
        const auto wanted = referee::default_placement(pitch, kind, restart.taker, restart.spot);
        const auto stands = put_down(pitch, restart, referee::Roles::any, wanted,
                                     Moved::everything(robots), Team::blue, disturbances);
        const auto bad = referee::misplaced_robots(pitch, restart, referee::Roles::any, stands);
        EXPECT_TRUE(bad[0].none() && bad[1].none()) << to_string(kind);
        EXPECT_TRUE(referee::may_put_ball(pitch, restart, stands.ball));
        EXPECT_LE(farther_axis(stands.ball - wanted.ball), 0.004 + 1e-12);
        for (int e = 0; e < 2; ++e) {
          for (int i = 0; i < robots; ++i) {
            const Vec2 off = stands.robots[e][i].position - wanted.robots[e][i].position;
            EXPECT_LE(farther_axis(off), 0.004 + 1e-12);
            exact += off.norm() < 1e-5 ? 1 : 0;
            ++all;
          }
        }
      }
    }
    EXPECT_LT(exact, all / 20) << "of " << all << " robots";
  }
}

TEST(PutDown, WhatNobodyTouchedStaysWhereItIs) {
  const Leg leg(short_setup(1));
  const referee::JudgedField& pitch = leg.pitch();
  Disturbances disturbances(conditions_of(ConditionsPreset::hall), 1, 3);
  referee::Decision restart;
  restart.restart = referee::Restart::KICK_OFF;
  const auto standing =
      put_down(pitch, restart, referee::Roles::any,
               referee::default_placement(pitch, restart.restart, restart.taker, restart.spot),
               Moved::everything(3), Team::blue, disturbances);
  auto wanted = standing;
  wanted.robots[0][2].position.y() += 0.01;
  const auto stands = put_down(pitch, restart, referee::Roles::any, wanted,
                               Moved::between(standing, wanted, 3), Team::blue, disturbances);
  EXPECT_EQ(stands.ball, standing.ball);
  EXPECT_EQ(stands.robots[0][1].position, standing.robots[0][1].position);
  EXPECT_EQ(stands.robots[1][0].position, standing.robots[1][0].position);
  EXPECT_NE(stands.robots[0][2].position, wanted.robots[0][2].position);
}

}  // namespace
}  // namespace mirocup::match
