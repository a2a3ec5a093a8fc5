// SPDX-License-Identifier: MIT
#include "core/referee/laws/wall_push.hpp"

#include <cmath>
#include <utility>

namespace mirocup::referee {

namespace {

bool at_end_wall(const JudgedField& pitch, const TickFacts& s, End end) {
  const double from_wall = pitch.field.half_length + attack_sign(end) * s.ball.x();
  return from_wall <= pitch.rules.wall_ball_m && std::abs(s.ball.y()) > pitch.field.goal_half_width;
}

RobotSet at_ball(const JudgedField& pitch, const TickFacts& s, End team) {
  const double reach = pitch.rules.wall_robot_m;
  RobotSet near;
  for (int i = 0; i < pitch.field.robots_per_team; ++i) {
    const Vec2 away = s.robots[index_of(team)][i].position - s.ball;
    near[i] = away.squaredNorm() <= reach * reach;
  }
  return near;
}

// Returns the robot that shoves the ball along the wall while a team-mate touches it, or nothing.
std::optional<RobotId> shover(const JudgedField& pitch, const TickFacts& s, End team, RobotSet near,
                              bool away_from_mouth) {
  const double from_mouth = (s.ball.y() > 0.0 ? 1.0 : -1.0) * (s.ball.y() - s.ball_before.y());
  if (away_from_mouth ? from_mouth <= 0.0 : from_mouth >= 0.0) return std::nullopt;
  for (int i = 0; i < pitch.field.robots_per_team; ++i) {
    const int t = index_of(team);
    if (near[i] && s.touched_ball[t][i] && s.touched_mates[t][i].any()) return RobotId{team, i};
  }
  return std::nullopt;
}

Decision free_ball(const JudgedField& pitch, const TickFacts& s, const Vec2& where,
                   std::string reason) {
  Decision d = decide(Verdict::FREE_BALL, Law::wall_push, s, std::move(reason));
  give_free_ball(pitch, where, d);
  return d;
}

}  // namespace

std::optional<Decision> judge_wall_push(const JudgedField& pitch, const TickFacts& s,
                                        WallPushMemory& memory) {
  if (!pitch.rules.wall_push) return std::nullopt;
  for (const End end : both_ends) {
    Dwell& pressed = memory.pressed[index_of(end)];
    if (!at_end_wall(pitch, s, end)) {
      pressed.sample(false, s.duration);
      continue;
    }
    const ByEnd<RobotSet> near{at_ball(pitch, s, End::left), at_ball(pitch, s, End::right)};
    pressed.sample(near[0].any() && near[1].any(), s.duration);
    if (pressed.reached(pitch.rules.wall_s, s.duration)) {
      Decision d = free_ball(pitch, s, s.ball,
                             "robots of both teams pressed the ball to the wall for " +
                                 fixed(pressed.for_s, 2) + " s");
      d.robots = near;
      return d;
    }
    for (const End team : {end, opposite(end)}) {
      const bool defends = team == end;
      const auto robot = shover(pitch, s, team, near[index_of(team)], defends);
      if (!robot) continue;
      const Vec2 where = defends ? s.ball : Vec2{-s.ball.x(), s.ball.y()};
      Decision d =
          free_ball(pitch, s, where,
                    name_of(*robot) + " shoved the ball along the wall with a team-mate behind it");
      d.team = team;
      d.add_robot(*robot);
      return d;
    }
  }
  return std::nullopt;
}

}  // namespace mirocup::referee
