// SPDX-License-Identifier: MIT
#include "core/referee/placement.hpp"

#include <vector>

namespace mirocup::referee {

namespace {

enum class Facing { forward, home, along };  // in the taker's frame: +x, -x, +y

struct Stand {
  double x, y;
  Facing facing;
};

// Of one restart, in the frame of the team that takes it: its own robots, then the opponents.
// Keeper, kicker or contender, others.
struct Table {
  Vec2 ball;
  std::vector<Stand> takers, opponents;
};

constexpr Facing forward = Facing::forward;
constexpr Facing home = Facing::home;
constexpr Facing along = Facing::along;

Table small_table(Restart restart) {
  switch (restart) {
    case Restart::none:
    case Restart::KICK_OFF:
      return {{0.0, 0.0},
              {{-0.7, 0.0, along}, {0.08, 0.0, home}, {-0.3, 0.0, forward}},
              {{0.7, 0.0, along}, {0.3, 0.0, home}, {0.45, 0.2, home}}};
    case Restart::PENALTY_KICK:
      return {{0.375, 0.0},
              {{-0.7, 0.0, along}, {0.3, 0.0, forward}, {-0.1, 0.25, forward}},
              {{0.7125, 0.0, along}, {-0.1, -0.25, forward}, {-0.1, -0.5, forward}}};
    case Restart::FREE_KICK:
      return {{0.375, 0.0},
              {{-0.7, 0.0, along}, {0.3, 0.0, forward}, {-0.1, 0.25, forward}},
              {{0.7125, 0.0, along}, {0.5625, 0.1375, home}, {0.5625, -0.1375, home}}};
    case Restart::GOAL_KICK:
      return {{-0.62, 0.2},
              {{-0.7, 0.2, forward}, {-0.45, 0.32, forward}, {-0.3, -0.47, forward}},
              {{0.7, 0.0, along}, {0.225, 0.1, home}, {0.15, -0.32, home}}};
    case Restart::FREE_BALL:
      return {{0.375, 0.4},
              {{-0.7, 0.0, along}, {0.175, 0.4, forward}, {-0.1, 0.2, forward}},
              {{0.7, 0.0, along}, {0.575, 0.4, home}, {0.3, -0.15, home}}};
  }
  return {};
}

Table middle_table(Restart restart) {
  switch (restart) {
    case Restart::none:
    case Restart::KICK_OFF:
      return {{0.0, 0.0},
              {{-1.05, 0.0, along},
               {0.08, 0.0, home},
               {-0.35, 0.0, forward},
               {-0.35, 0.45, forward},
               {-0.35, -0.45, forward}},
              {{1.05, 0.0, along},
               {0.35, 0.25, home},
               {0.35, -0.25, home},
               {0.6, 0.0, home},
               {0.7, 0.45, home}}};
    case Restart::PENALTY_KICK:
      return {{0.725, 0.0},
              {{-1.03, 0.0, along},
               {0.65, 0.0, forward},
               {-0.083, 0.6, forward},
               {-0.083, 0.0, forward},
               {-0.083, -0.6, forward}},
              {{1.0625, 0.0, along},
               {-0.083, 0.31, forward},
               {-0.083, 0.81, forward},
               {-0.083, -0.31, forward},
               {-0.083, -0.81, forward}}};
    case Restart::FREE_KICK:
      return {{0.725, 0.0},
              {{-1.05, 0.0, along},
               {0.65, 0.0, forward},
               {-0.1, 0.4, forward},
               {-0.1, -0.4, forward},
               {-0.3, 0.0, forward}},
              {{1.0625, 0.0, along},
               {0.9125, 0.2125, home},
               {0.9125, -0.2125, home},
               {0.9125, 0.4375, home},
               {0.9125, -0.4375, home}}};
    case Restart::GOAL_KICK:
      return {{-0.98, 0.0},
              {{-1.06, 0.0, forward},
               {-0.45, 0.45, forward},
               {-0.45, -0.45, forward},
               {-0.15, 0.7, forward},
               {-0.15, -0.7, forward}},
              {{1.05, 0.0, along},
               {0.2, 0.3, home},
               {0.2, -0.3, home},
               {0.5, 0.0, home},
               {0.7, 0.5, home}}};
    case Restart::FREE_BALL:
      return {{0.55, 0.6},
              {{-1.05, 0.0, along},
               {0.3, 0.6, forward},
               {-0.2, 0.4, forward},
               {-0.2, -0.4, forward},
               {0.3, -0.2, forward}},
              {{1.05, 0.0, along},
               {0.8, 0.6, home},
               {0.6, -0.15, home},
               {0.2, -0.6, home},
               {0.85, -0.4, home}}};
  }
  return {};
}

// Nine robots in a column of five and one of four.
void add_columns(std::vector<Stand>& stands, double first, double second, Facing facing,
                 double shift) {
  for (const double y : {-1.0, -0.5, 0.0, 0.5, 1.0}) stands.push_back({first, y + shift, facing});
  for (const double y : {-0.75, -0.25, 0.25, 0.75}) stands.push_back({second, y + shift, facing});
}

Table large_table(Restart restart) {
  Table table;
  switch (restart) {
    case Restart::none:
    case Restart::KICK_OFF:
      table = {{0.0, 0.0},
               {{-1.95, 0.0, along}, {0.08, 0.0, home}},
               {{1.95, 0.0, along}, {0.85, 0.25, home}}};
      add_columns(table.takers, -0.5, -1.1, forward, 0.0);
      add_columns(table.opponents, 1.0, 1.5, home, 0.0);
      break;
    case Restart::PENALTY_KICK:
      table = {{1.5, 0.0},
               {{-1.95, 0.0, along}, {1.42, 0.0, forward}},
               {{1.9625, 0.0, along}, {-0.1, 0.25, forward}}};
      add_columns(table.takers, -0.3, -0.6, forward, 0.1);
      add_columns(table.opponents, -0.3, -0.6, forward, -0.1);
      break;
    case Restart::FREE_KICK:
      table = {{1.5, 0.0},
               {{-1.95, 0.0, along}, {1.42, 0.0, forward}},
               {{1.9625, 0.0, along},
                {1.7125, 0.3875, home},
                {1.7125, -0.3875, home},
                {1.7125, 0.6375, home},
                {1.7125, -0.6375, home}}};
      add_columns(table.takers, -0.3, -0.6, forward, 0.1);
      for (const double y : {-1.0, -0.6, -0.2, 0.2, 0.6, 1.0}) {
        table.opponents.push_back({0.6, y, home});
      }
      break;
    case Restart::GOAL_KICK:
      table = {{-1.8, 0.0},
               {{-1.9, 0.0, forward}, {-1.1, 0.25, forward}},
               {{1.95, 0.0, along}, {0.3, 0.25, home}}};
      add_columns(table.takers, -0.9, -0.4, forward, 0.0);
      add_columns(table.opponents, 0.5, 1.1, home, 0.0);
      break;
    case Restart::FREE_BALL:
      table = {{1.0, 2.80 / 3.0},
               {{-1.95, 0.0, along}, {0.7, 2.80 / 3.0, forward}},
               {{1.95, 0.0, along}, {1.3, 2.80 / 3.0, home}}};
      add_columns(table.takers, -0.3, -0.9, forward, 0.0);
      for (const double y : {-0.2, -0.6, -1.0}) {
        for (const double x : {0.4, 0.9, 1.5}) table.opponents.push_back({x, y, home});
      }
      break;
  }
  return table;
}

Table table_of(League league, Restart restart) {
  switch (league) {
    case League::small:
      return small_table(restart);
    case League::middle:
      return middle_table(restart);
    case League::large:
      return large_table(restart);
  }
  return {};
}

Pose pose_of(const Stand& stand) {
  switch (stand.facing) {
    case Facing::forward:
      return {{stand.x, stand.y}, {1.0, 0.0}};
    case Facing::home:
      return {{stand.x, stand.y}, {-1.0, 0.0}};
    case Facing::along:
      return {{stand.x, stand.y}, {0.0, 1.0}};
  }
  return {};
}

}  // namespace

Placement default_placement(const Pitch& pitch, Restart restart, End taker, const Vec2& spot) {
  const field::Field& field = pitch.field;
  Table table = table_of(field.league, restart);
  if (restart == Restart::KICK_OFF && pitch.rules.kickoff_behind) {
    Stand& stand = table.takers[kicker];
    stand = {-stand.x, stand.y, Facing::forward};
  }
  // The tables show a free ball in the quarter x > 0, y > 0 with the attacker of that half on the
  // left. A quarter with y < 0 is that one mirrored, which keeps the headings.
  const bool free_ball = restart == Restart::FREE_BALL;
  const End first = free_ball ? (spot.x() > 0.0 ? End::left : End::right) : taker;
  const bool flip = free_ball && team_frame(first, spot).y() < 0.0;

  const auto place = [&](const Stand& stand) {
    Pose pose = pose_of(stand);
    if (flip) pose.position.y() = -pose.position.y();
    return team_frame(first, pose);
  };
  Placement placement;
  placement.ball = team_frame(first, Vec2{table.ball.x(), flip ? -table.ball.y() : table.ball.y()});
  for (int i = 0; i < field.robots_per_team; ++i) {
    placement.robots[index_of(first)][i] = place(table.takers[i]);
    placement.robots[index_of(opposite(first))][i] = place(table.opponents[i]);
  }
  return placement;
}

}  // namespace mirocup::referee
