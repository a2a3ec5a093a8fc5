// SPDX-License-Identifier: MIT
#include "core/referee/laws/kick_off.hpp"

#include <algorithm>
#include <cmath>

namespace mirocup::referee {

namespace {

// Returns the point of the ball's path in this tick that is the first at `distance` from the spot.
Vec2 leaves_circle(const Vec2& spot, double distance, const Vec2& from, const Vec2& to) {
  const Vec2 start = from - spot;
  const Vec2 step = to - from;
  const double a = step.squaredNorm();
  if (a == 0.0) return to;
  const double b = start.dot(step);
  const double c = start.squaredNorm() - distance * distance;
  const double share = (-b + std::sqrt(std::max(b * b - a * c, 0.0))) / a;
  return from + std::clamp(share, 0.0, 1.0) * step;
}

Decision violation(const TickFacts& s, const KickOffMemory& memory, std::string reason) {
  Decision d = decide(Verdict::KICK_OFF_VIOLATION, Law::kick_off, s, std::move(reason));
  d.team = memory.taker;
  d.restart = Restart::KICK_OFF;
  d.taker = opposite(memory.taker);
  return d;
}

}  // namespace

std::optional<Decision> judge_kick_off(const JudgedField& pitch, const TickFacts& s,
                                       KickOffMemory& memory) {
  if (!memory.is_pending) return std::nullopt;
  const Rules& rules = pitch.rules;

  memory.waited_s += s.duration;
  memory.was_touched = memory.was_touched || s.touched_ball[0].any() || s.touched_ball[1].any();
  if (!memory.was_touched && memory.waited_s + s.duration / 2.0 >= rules.kickoff_limit_s) {
    return violation(s, memory, "nobody touched the ball for " + fixed(memory.waited_s, 1) + " s");
  }

  const double moved = std::sqrt((s.ball - memory.spot).squaredNorm());
  if (moved < rules.kickoff_move_m) return std::nullopt;
  memory.is_pending = false;
  if (!rules.kickoff_backward_required) return std::nullopt;
  const Vec2 at = leaves_circle(memory.spot, rules.kickoff_move_m, s.ball_before, s.ball);
  const double forward = attack_sign(memory.taker) * (at.x() - memory.spot.x());
  if (forward < 0.0) return std::nullopt;
  return violation(s, memory,
                   "the ball first moved " + fixed(forward, 3) + " m towards the opponents' side");
}

}  // namespace mirocup::referee
