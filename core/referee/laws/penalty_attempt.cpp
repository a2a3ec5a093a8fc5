// SPDX-License-Identifier: MIT
#include "core/referee/laws/penalty_attempt.hpp"

namespace mirocup::referee {

std::optional<std::string> judge_penalty_attempt(const JudgedField& pitch, const TickFacts& s,
                                                 const Occupancy& occupancy, bool is_stalemate,
                                                 PenaltyAttemptMemory& memory) {
  const Rules& rules = pitch.rules;
  const End goal = opposite(memory.taker);
  const std::optional<RobotId>& keeper = occupancy.keeper[index_of(goal)];
  const bool in_area = pitch.field.inside(pitch.field.goal_area, goal, s.ball);
  memory.for_s += s.duration;
  memory.held.sample(
      keeper && s.touches_ball(*keeper) && s.touched_ball[index_of(memory.taker)].none(),
      s.duration);
  const bool came_out = memory.was_in_area && !in_area;
  memory.was_in_area = memory.was_in_area || in_area;

  if (came_out) return "the ball was in the goal area and is out again";
  if (memory.held.reached(rules.attempt_hold_s, s.duration)) {
    return "the keeper held the ball for " + fixed(memory.held.for_s, 2) + " s";
  }
  if (memory.for_s + s.duration / 2.0 >= rules.attempt_s) {
    return "no goal in " + fixed(memory.for_s, 1) + " s";
  }
  if (ball_in_half(s, memory.taker)) return "the ball went back over the half line";
  if (is_stalemate) return "the ball got nowhere for " + fixed(rules.stalemate_s, 1) + " s";
  return std::nullopt;
}

}  // namespace mirocup::referee
