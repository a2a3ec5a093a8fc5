// SPDX-License-Identifier: MIT
#include "core/referee/laws/goal.hpp"

#include <cmath>

namespace mirocup::referee {

std::optional<Decision> judge_goal(const JudgedField& pitch, const TickFacts& s) {
  const double line = pitch.field.half_length + pitch.ball_radius;
  for (const End goal : both_ends) {
    // Outward distance, as if at the right end.
    const double out = -attack_sign(goal);
    const double before = out * s.ball_before.x();
    const double now = out * s.ball.x();
    if (before > line || now <= line) continue;
    const double share = (line - before) / (now - before);
    double y = s.ball_before.y() + share * (s.ball.y() - s.ball_before.y());
    if (std::abs(y) >= pitch.field.goal_half_width) {
      // A ball that lies in the goal came in between the posts, by a path that was not straight.
      if (std::abs(s.ball.y()) >= pitch.field.goal_half_width) continue;
      y = s.ball.y();
    }

    const bool own = s.last_touch && s.last_touch->end == goal;
    Decision d = decide(Verdict::GOAL, own ? Law::own_goal : Law::goal, s, "");
    d.clock = s.begin + share * s.duration;
    d.team = opposite(goal);
    d.restart = Restart::KICK_OFF;
    d.taker = goal;
    d.reason = "the ball crossed the line of the " + std::string(to_string(goal)) +
               " goal at y = " + fixed(y, 3) + " m";
    return d;
  }
  return std::nullopt;
}

}  // namespace mirocup::referee
