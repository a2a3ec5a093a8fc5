// SPDX-License-Identifier: MIT
#include "core/referee/placement.hpp"

#include <algorithm>
#include <array>

namespace mirocup::referee {

namespace {

// Where a robot looks, in the taker's frame.
constexpr Heading forward{1.0, 0.0};
constexpr Heading home{-1.0, 0.0};
constexpr Heading along{0.0, 1.0};

// The place of one robot, in metres.
struct Stand {
  double x = 0.0;
  double y = 0.0;
  Heading facing;
};

using Stands = std::array<Stand, max_robots_per_team>;

// The places at one restart, in the frame of the team that takes it. The first robot of a team is
// its keeper, the second its kicker or contender. Leagues with smaller teams use the first places.
struct Formation {
  Restart restart;
  Vec2 ball;
  Stands takers, opponents;
};

// The formations of a league. A free ball is drawn for the quarter x > 0, y > 0.
using Formations = std::array<Formation, 5>;

constexpr Formations small_formations{{
    {.restart = Restart::KICK_OFF,
     .ball = {0.0, 0.0},
     .takers = {{{-0.7, 0.0, along}, {0.08, 0.0, home}, {-0.3, 0.0, forward}}},
     .opponents = {{{0.7, 0.0, along}, {0.3, 0.0, home}, {0.45, 0.2, home}}}},
    {.restart = Restart::PENALTY_KICK,
     .ball = {0.375, 0.0},
     .takers = {{{-0.7, 0.0, along}, {0.3, 0.0, forward}, {-0.1, 0.25, forward}}},
     .opponents = {{{0.7125, 0.0, along}, {-0.1, -0.25, forward}, {-0.1, -0.5, forward}}}},
    {.restart = Restart::FREE_KICK,
     .ball = {0.375, 0.0},
     .takers = {{{-0.7, 0.0, along}, {0.3, 0.0, forward}, {-0.1, 0.25, forward}}},
     .opponents = {{{0.7125, 0.0, along}, {0.5625, 0.1375, home}, {0.5625, -0.1375, home}}}},
    {.restart = Restart::GOAL_KICK,
     .ball = {-0.62, 0.2},
     .takers = {{{-0.7, 0.2, forward}, {-0.45, 0.32, forward}, {-0.3, -0.47, forward}}},
     .opponents = {{{0.7, 0.0, along}, {0.225, 0.1, home}, {0.15, -0.32, home}}}},
    {.restart = Restart::FREE_BALL,
     .ball = {0.375, 0.4},
     .takers = {{{-0.7, 0.0, along}, {0.175, 0.4, forward}, {-0.1, 0.2, forward}}},
     .opponents = {{{0.7, 0.0, along}, {0.575, 0.4, home}, {0.3, -0.15, home}}}},
}};

constexpr Formations middle_formations{{
    {.restart = Restart::KICK_OFF,
     .ball = {0.0, 0.0},
     .takers = {{{-1.05, 0.0, along},
                 {0.08, 0.0, home},
                 {-0.35, 0.0, forward},
                 {-0.35, 0.45, forward},
                 {-0.35, -0.45, forward}}},
     .opponents = {{{1.05, 0.0, along},
                    {0.35, 0.25, home},
                    {0.35, -0.25, home},
                    {0.6, 0.0, home},
                    {0.7, 0.45, home}}}},
    {.restart = Restart::PENALTY_KICK,
     .ball = {0.725, 0.0},
     .takers = {{{-1.03, 0.0, along},
                 {0.65, 0.0, forward},
                 {-0.083, 0.6, forward},
                 {-0.083, 0.0, forward},
                 {-0.083, -0.6, forward}}},
     .opponents = {{{1.0625, 0.0, along},
                    {-0.083, 0.31, forward},
                    {-0.083, 0.81, forward},
                    {-0.083, -0.31, forward},
                    {-0.083, -0.81, forward}}}},
    {.restart = Restart::FREE_KICK,
     .ball = {0.725, 0.0},
     .takers = {{{-1.05, 0.0, along},
                 {0.65, 0.0, forward},
                 {-0.1, 0.4, forward},
                 {-0.1, -0.4, forward},
                 {-0.3, 0.0, forward}}},
     .opponents = {{{1.0625, 0.0, along},
                    {0.9125, 0.2125, home},
                    {0.9125, -0.2125, home},
                    {0.9125, 0.4375, home},
                    {0.9125, -0.4375, home}}}},
    {.restart = Restart::GOAL_KICK,
     .ball = {-0.98, 0.0},
     .takers = {{{-1.06, 0.0, forward},
                 {-0.45, 0.45, forward},
                 {-0.45, -0.45, forward},
                 {-0.15, 0.7, forward},
                 {-0.15, -0.7, forward}}},
     .opponents = {{{1.05, 0.0, along},
                    {0.2, 0.3, home},
                    {0.2, -0.3, home},
                    {0.5, 0.0, home},
                    {0.7, 0.5, home}}}},
    {.restart = Restart::FREE_BALL,
     .ball = {0.55, 0.6},
     .takers = {{{-1.05, 0.0, along},
                 {0.3, 0.6, forward},
                 {-0.2, 0.4, forward},
                 {-0.2, -0.4, forward},
                 {0.3, -0.2, forward}}},
     .opponents = {{{1.05, 0.0, along},
                    {0.8, 0.6, home},
                    {0.6, -0.15, home},
                    {0.2, -0.6, home},
                    {0.85, -0.4, home}}}},
}};

// Returns the places of keeper and kicker, and of nine robots in columns of five and four.
constexpr Stands in_columns(const Stand& keeper_stand, const Stand& kicker_stand, double first_x,
                            double second_x, const Heading& facing, double shift_y) {
  return {{keeper_stand,
           kicker_stand,
           {first_x, -1.0 + shift_y, facing},
           {first_x, -0.5 + shift_y, facing},
           {first_x, 0.0 + shift_y, facing},
           {first_x, 0.5 + shift_y, facing},
           {first_x, 1.0 + shift_y, facing},
           {second_x, -0.75 + shift_y, facing},
           {second_x, -0.25 + shift_y, facing},
           {second_x, 0.25 + shift_y, facing},
           {second_x, 0.75 + shift_y, facing}}};
}

constexpr Formations large_formations{{
    {.restart = Restart::KICK_OFF,
     .ball = {0.0, 0.0},
     .takers = in_columns({-1.95, 0.0, along}, {0.08, 0.0, home}, -0.5, -1.1, forward, 0.0),
     .opponents = in_columns({1.95, 0.0, along}, {0.85, 0.25, home}, 1.0, 1.5, home, 0.0)},
    {.restart = Restart::PENALTY_KICK,
     .ball = {1.5, 0.0},
     .takers = in_columns({-1.95, 0.0, along}, {1.42, 0.0, forward}, -0.3, -0.6, forward, 0.1),
     .opponents =
         in_columns({1.9625, 0.0, along}, {-0.1, 0.25, forward}, -0.3, -0.6, forward, -0.1)},
    {.restart = Restart::FREE_KICK,
     .ball = {1.5, 0.0},
     .takers = in_columns({-1.95, 0.0, along}, {1.42, 0.0, forward}, -0.3, -0.6, forward, 0.1),
     .opponents = {{{1.9625, 0.0, along},
                    {1.7125, 0.3875, home},
                    {1.7125, -0.3875, home},
                    {1.7125, 0.6375, home},
                    {1.7125, -0.6375, home},
                    {0.6, -1.0, home},
                    {0.6, -0.6, home},
                    {0.6, -0.2, home},
                    {0.6, 0.2, home},
                    {0.6, 0.6, home},
                    {0.6, 1.0, home}}}},
    {.restart = Restart::GOAL_KICK,
     .ball = {-1.8, 0.0},
     .takers = in_columns({-1.9, 0.0, forward}, {-1.1, 0.25, forward}, -0.9, -0.4, forward, 0.0),
     .opponents = in_columns({1.95, 0.0, along}, {0.3, 0.25, home}, 0.5, 1.1, home, 0.0)},
    {.restart = Restart::FREE_BALL,
     .ball = {1.0, 2.80 / 3.0},
     .takers =
         in_columns({-1.95, 0.0, along}, {0.7, 2.80 / 3.0, forward}, -0.3, -0.9, forward, 0.0),
     .opponents = {{{1.95, 0.0, along},
                    {1.3, 2.80 / 3.0, home},
                    {0.4, -0.2, home},
                    {0.9, -0.2, home},
                    {1.5, -0.2, home},
                    {0.4, -0.6, home},
                    {0.9, -0.6, home},
                    {1.5, -0.6, home},
                    {0.4, -1.0, home},
                    {0.9, -1.0, home},
                    {1.5, -1.0, home}}}},
}};

// Without a restart all stand as at a kick-off, which comes first.
const Formation& formation_of(RobotLeague league, Restart restart) {
  const Formations& all = league == RobotLeague::large    ? large_formations
                          : league == RobotLeague::middle ? middle_formations
                                                          : small_formations;
  const auto found = std::ranges::find(all, restart, &Formation::restart);
  return found != all.end() ? *found : all.front();
}

}  // namespace

Placement default_placement(const JudgedField& pitch, Restart restart, End taker,
                            const Vec2& spot) {
  const field::Field& field = pitch.field;
  const Formation& formation = formation_of(field.league, restart);
  // A formation shows a free ball in the quarter x > 0, y > 0 with the attacker of that half on the
  // left. For a quarter with y < 0 it is mirrored, which keeps the headings.
  const bool is_free_ball = restart == Restart::FREE_BALL;
  const End first = is_free_ball ? (spot.x() > 0.0 ? End::left : End::right) : taker;
  const bool flip = is_free_ball && team_frame(first, spot).y() < 0.0;

  const auto place = [&](const Stand& stand) {
    return team_frame(first, Pose{{stand.x, flip ? -stand.y : stand.y}, stand.facing});
  };
  Placement placement;
  const Vec2& ball = formation.ball;
  placement.ball = team_frame(first, Vec2{ball.x(), flip ? -ball.y() : ball.y()});
  for (int i = 0; i < field.robots_per_team; ++i) {
    placement.robots[index_of(first)][i] = place(formation.takers[i]);
    placement.robots[index_of(opposite(first))][i] = place(formation.opponents[i]);
  }
  if (restart == Restart::KICK_OFF && pitch.rules.kickoff_behind) {
    const Stand& stand = formation.takers[kicker];
    placement.robots[index_of(first)][kicker] = place({-stand.x, stand.y, forward});
  }
  return placement;
}

}  // namespace mirocup::referee
