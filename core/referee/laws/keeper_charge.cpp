// SPDX-License-Identifier: MIT
#include "core/referee/laws/keeper_charge.hpp"

#include <algorithm>
#include <cmath>

namespace mirocup::referee {

namespace {

// True if the ball lies between the two and touches one of them.
bool ball_is_between(const JudgedField& pitch, const TickFacts& s, const RobotId& a,
                     const RobotId& b) {
  if (!s.touches_ball(a) && !s.touches_ball(b)) return false;
  const Vec2 from = s.pose(a).position;
  const Vec2 offset = s.pose(b).position - from;
  const double length = offset.squaredNorm();
  const double along = length > 0.0 ? (s.ball - from).dot(offset) / length : 0.0;
  const Vec2 nearest = from + std::clamp(along, 0.0, 1.0) * offset;
  const double reach = pitch.robot_side / 2.0 + pitch.ball_radius;
  return (s.ball - nearest).squaredNorm() <= reach * reach;
}

bool is_near_enough(const JudgedField& pitch, const TickFacts& s, End end) {
  return pitch.rules.zone_depth_m > 0.0 ? ball_in_zone(pitch, s, end) : ball_in_half(s, end);
}

// Returns the closing speed along the line of centres, m/s; 0 if the keeper came at the attacker
// faster than the attacker at the keeper.
double closing_speed(const TickFacts& s, const RobotId& attacker, const RobotId& keeper) {
  const Vec2 offset = s.pose(keeper).position - s.pose(attacker).position;
  const double length = std::sqrt(offset.squaredNorm());
  if (length == 0.0) return 0.0;
  const double own = s.velocity[index_of(attacker.end)][attacker.index].dot(offset) / length;
  const double other = -s.velocity[index_of(keeper.end)][keeper.index].dot(offset) / length;
  return own >= other ? own + other : 0.0;
}

}  // namespace

std::optional<Decision> judge_keeper_charge(const JudgedField& pitch, const TickFacts& s,
                                            const Occupancy& occupancy,
                                            KeeperChargeMemory& memory) {
  const Rules& rules = pitch.rules;
  if (rules.charge_s == off && rules.charge_speed_mps == off) return std::nullopt;
  std::optional<Decision> called;
  for (const End end : ends_from_ball(s)) {
    const std::optional<RobotId>& keeper = occupancy.keeper[index_of(end)];
    const End team = opposite(end);
    for (int i = 0; i < pitch.field.robots_per_team; ++i) {
      const RobotId attacker{team, i};
      Dwell& driven = memory.driven[index_of(team)][i];
      bool& touched = memory.touched[index_of(team)][i];
      const bool touches = keeper && s.touch(attacker, keeper->index);
      const bool is_first = touches && !touched;
      touched = touches;
      const bool is_foul =
          touches && is_near_enough(pitch, s, end) && !ball_is_between(pitch, s, attacker, *keeper);
      driven.sample(is_foul && drives_at(pitch, s, attacker, *keeper), s.duration);
      if (called || !is_foul) continue;

      const double speed = is_first ? closing_speed(s, attacker, *keeper) : -1.0;
      const bool too_hard = speed >= rules.charge_speed_mps;
      if (!too_hard && !driven.reached(rules.charge_s, s.duration)) continue;
      called =
          decide(Verdict::GOAL_KICK, Law::keeper_charge, s,
                 name_of(attacker) + " " +
                     (too_hard ? "hit the keeper at " + fixed(speed, 2) + " m/s"
                               : "drove into the keeper for " + fixed(driven.for_s, 2) + " s") +
                     ", the ball not between them");
      called->add_robot(attacker);
      called->add_robot(*keeper);
      called = against(*std::move(called), team, Restart::GOAL_KICK);
    }
  }
  return called;
}

}  // namespace mirocup::referee
