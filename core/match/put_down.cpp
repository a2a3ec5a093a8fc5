// SPDX-License-Identifier: MIT
#include "core/match/put_down.hpp"

#include "core/base/math.hpp"

namespace mirocup::match {

namespace {

// So often the errors of the bodies in question are halved, and after that so often those of all
// bodies; then everything stands exactly where it was meant to.
constexpr int own_halvings = 8;
constexpr int common_halvings = 4;

bool is_same(const Pose& a, const Pose& b) {
  return a.position == b.position && a.heading.cos == b.heading.cos &&
         a.heading.sin == b.heading.sin;
}

Pose off_by(const PlacingError& error, const Pose& pose) {
  const double turn = error.turn;
  return {pose.position + error.offset,
          turn == 0.0 ? pose.heading : pose.heading.turned(sincos(turn))};
}

void halve(PlacingError& error) {
  error.offset *= 0.5;
  error.turn *= 0.5;
}

}  // namespace

Moved Moved::between(const referee::Placement& from, const referee::Placement& to,
                     int robots_per_team) {
  Moved moved{.robots = {}, .ball = from.ball != to.ball};
  for (const End end : both_ends) {
    const int e = index_of(end);
    for (int i = 0; i < robots_per_team; ++i) {
      moved.robots[e][i] = !is_same(from.robots[e][i], to.robots[e][i]);
    }
  }
  return moved;
}

Moved Moved::everything(int robots_per_team) {
  Moved moved{.robots = {}, .ball = true};
  for (referee::RobotSet& robots : moved.robots) {
    for (int i = 0; i < robots_per_team; ++i) robots.set(i);
  }
  return moved;
}

referee::Placement put_down(const referee::JudgedField& pitch, const referee::Decision& restart,
                            referee::Roles roles, const referee::Placement& wanted,
                            const Moved& moved, Team left, Disturbances& disturbances) {
  const int robots = pitch.field.robots_per_team;
  const auto team_at = [left](End end) { return end == End::left ? left : opponent_of(left); };
  const auto end_of = [left](Team team) { return team == left ? End::left : End::right; };

  referee::ByRobot<PlacingError> errors{};  // in the field's frame
  Vec2 ball_error{0.0, 0.0};
  if (moved.ball) ball_error = team_frame(end_of(Team::blue), disturbances.put_down_ball());
  for (const End end : both_ends) {
    for (int i = 0; i < robots; ++i) {
      if (!moved.robots[index_of(end)][i]) continue;
      const PlacingError own = disturbances.put_down_robot(team_at(end), i);
      errors[index_of(end)][i] = {team_frame(end, own.offset), own.turn};
    }
  }

  referee::Placement result = wanted;
  for (int round = 0; round < own_halvings + common_halvings; ++round) {
    result.ball = wanted.ball + ball_error;
    for (int e = 0; e < 2; ++e) {
      for (int i = 0; i < robots; ++i) {
        result.robots[e][i] = off_by(errors[e][i], wanted.robots[e][i]);
      }
    }
    const bool ball_is_fine = !moved.ball || referee::may_put_ball(pitch, restart, result.ball);
    const auto misplaced = referee::misplaced_robots(pitch, restart, roles, result);
    if (ball_is_fine && misplaced[0].none() && misplaced[1].none()) return result;

    const bool all = round >= own_halvings;
    if (all || !ball_is_fine) ball_error *= 0.5;
    for (int e = 0; e < 2; ++e) {
      for (int i = 0; i < robots; ++i) {
        if (all || misplaced[e][i]) halve(errors[e][i]);
      }
    }
  }
  return wanted;
}

}  // namespace mirocup::match
