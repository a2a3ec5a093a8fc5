// SPDX-License-Identifier: MIT
#include "core/referee/laws/stalemate.hpp"

namespace mirocup::referee {

bool is_stalemate(const Pitch& pitch, const StalemateMemory& memory, double duration) {
  return memory.still_s + duration / 2.0 >= pitch.rules.stalemate_s;
}

std::optional<Decision> judge_stalemate(const Pitch& pitch, const Situation& s,
                                        StalemateMemory& memory) {
  const field::Field& field = pitch.field;
  const double radius = pitch.rules.stalemate_radius_m;
  if (!memory.anchor) memory.anchor = s.ball_before;
  memory.still_s += s.duration;
  if ((s.ball - *memory.anchor).squaredNorm() > radius * radius) {
    memory.anchor = s.ball;
    memory.still_s = 0.0;
  }
  if (!is_stalemate(pitch, memory, s.duration)) return std::nullopt;

  const std::string reason =
      "the ball stayed within " + fixed(radius, 3) + " m for " + fixed(memory.still_s, 1) + " s";
  for (const End end : both_ends) {
    if (!field.inside(field.goal_area, end, s.ball)) continue;
    // An uncontested ball must be kicked out by the keeper; the law keeper_hold judges that, if it
    // is on.
    if (!is_contested(pitch, s, end) && pitch.rules.keeper_hold_s != off) return std::nullopt;
    Decision d = decide(Verdict::GOAL_KICK, Law::stalemate, s,
                        reason + " in the " + std::string(to_string(end)) + " goal area");
    d.restart = Restart::GOAL_KICK;
    d.taker = end;
    return d;
  }
  Decision d = decide(Verdict::FREE_BALL, Law::stalemate, s, reason);
  give_free_ball(pitch, s.ball, d);
  return d;
}

}  // namespace mirocup::referee
