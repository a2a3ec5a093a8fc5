// SPDX-License-Identifier: MIT
#include "core/referee/laws/stalemate.hpp"

namespace mirocup::referee {

bool is_stalemate(const JudgedField& pitch, const StalemateMemory& memory, double duration) {
  return memory.still_s + duration / 2.0 >= pitch.rules.stalemate_s;
}

namespace {

bool judges_by_speed(const Rules& rules) {
  return rules.stalemate_speed_mps > 0.0;
}

bool has_moved(const Rules& rules, const TickFacts& s, const Vec2& anchor) {
  if (judges_by_speed(rules)) {
    const double slow = rules.stalemate_speed_mps * s.duration;  // m in this tick
    return (s.ball - s.ball_before).squaredNorm() > slow * slow;
  }
  const double radius = rules.stalemate_radius_m;
  return (s.ball - anchor).squaredNorm() > radius * radius;
}

std::string reason_of(const Rules& rules, const StalemateMemory& memory) {
  const std::string how = judges_by_speed(rules)
                              ? "was no faster than " + fixed(rules.stalemate_speed_mps, 2) + " m/s"
                              : "stayed within " + fixed(rules.stalemate_radius_m, 3) + " m";
  return "the ball " + how + " for " + fixed(memory.still_s, 1) + " s";
}

// VSSReferee's call for a ball that gets nowhere in a goal area.
Decision in_goal_area_of(const JudgedField& pitch, const TickFacts& s, End end,
                         const std::string& why) {
  if (is_contested(pitch, s, end) && is_contested(pitch, s, opposite(end))) {
    Decision d = decide(Verdict::FREE_BALL, Law::stalemate, s, why + ", robots of both at it");
    give_free_ball(pitch, s.ball, d);
    return d;
  }
  Decision d = decide(Verdict::PENALTY_KICK, Law::stalemate, s, why + ", not of both teams");
  return against(std::move(d), end, Restart::PENALTY_KICK);
}

}  // namespace

std::optional<Decision> judge_stalemate(const JudgedField& pitch, const TickFacts& s,
                                        StalemateMemory& memory) {
  const field::Field& field = pitch.field;
  if (!memory.anchor) memory.anchor = s.ball_before;
  memory.still_s += s.duration;
  if (has_moved(pitch.rules, s, *memory.anchor)) {
    memory.anchor = s.ball;
    memory.still_s = 0.0;
  }
  if (!is_stalemate(pitch, memory, s.duration)) return std::nullopt;

  const std::string reason = reason_of(pitch.rules, memory);

  for (const End end : both_ends) {
    if (!field.inside(field.goal_area, end, s.ball)) continue;
    if (pitch.rules.stalemate_penalty) {
      return in_goal_area_of(pitch, s, end,
                             reason + " in the " + std::string(to_string(end)) + " goal area");
    }
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
