// SPDX-License-Identifier: MIT
#include "core/referee/laws/keeper_push_in.hpp"

#include <cmath>
#include <utility>

namespace mirocup::referee {

namespace {

PushInTick tick_of(const JudgedField& pitch, const TickFacts& s, const RobotId& keeper,
                   std::optional<double> x_before) {
  const End end = keeper.end;
  const double towards_line = -attack_sign(end);
  PushInTick tick;
  tick.duration = s.duration;
  const double x = s.pose(keeper).position.x();
  if (x_before) tick.moved = towards_line * (x - *x_before);
  tick.attackers = s.touched_opponents[index_of(end)][keeper.index];
  if (s.touches_ball(keeper)) tick.attackers |= s.touched_ball[index_of(opposite(end))];
  tick.pressed = tick.attackers.any();
  tick.backs_itself =
      towards_line * s.commanded[index_of(end)][keeper.index].x() >= pitch.rules.drive_mps;
  return tick;
}

// True if any corner of the robot is behind the goal line of that end.
bool is_over_line(const JudgedField& pitch, const Pose& robot, End end) {
  const double h = pitch.robot_side / 2.0;
  const double corner = h * (std::abs(robot.heading.cos) + std::abs(robot.heading.sin));
  return -attack_sign(end) * robot.position.x() + corner > pitch.field.half_length;
}

void remember(const JudgedField& pitch, const TickFacts& s, const Occupancy& occupancy,
              KeeperPushInMemory& memory) {
  for (const End end : both_ends) {
    const int e = index_of(end);
    // A keeper that was pushed out of its area, over the line, still counts as the keeper.
    const std::optional<RobotId> keeper =
        occupancy.keeper[e] ? occupancy.keeper[e] : memory.keeper[e];
    PushInTick& tick = memory.ticks[e][memory.next];
    tick = {};
    if (keeper) {
      const bool same = keeper == memory.keeper[e];
      tick = tick_of(pitch, s, *keeper,
                     same ? std::optional<double>(memory.keeper_x[e]) : std::nullopt);
      memory.keeper_x[e] = s.pose(*keeper).position.x();
    }
    memory.keeper[e] = keeper;
  }
  memory.next = (memory.next + 1) % static_cast<int>(memory.ticks[0].size());
}

}  // namespace

std::optional<Decision> judge_keeper_push_in(const JudgedField& pitch, const TickFacts& s,
                                             const Occupancy& occupancy, std::optional<End> goal_at,
                                             KeeperPushInMemory& memory) {
  const Rules& rules = pitch.rules;
  remember(pitch, s, occupancy, memory);
  if (!goal_at || rules.push_in_m == off) return std::nullopt;
  const int e = index_of(*goal_at);
  const std::optional<RobotId>& keeper = memory.keeper[e];
  if (!keeper) return std::nullopt;
  if (!s.touches_ball(*keeper) && !is_over_line(pitch, s.pose(*keeper), *goal_at)) {
    return std::nullopt;
  }

  const int size = static_cast<int>(memory.ticks[e].size());
  double moved = 0.0;
  double looked_back = 0.0;
  bool by_itself = true;
  RobotSet attackers;
  for (int k = 1; k <= size && looked_back < rules.push_in_s; ++k) {
    const PushInTick& tick = memory.ticks[e][(memory.next - k + size) % size];
    looked_back += tick.duration;
    if (!tick.pressed) continue;
    moved += tick.moved;
    by_itself = by_itself && tick.backs_itself;
    attackers |= tick.attackers;
  }
  if (attackers.none() || by_itself || moved < rules.push_in_m) return std::nullopt;

  const End team = opposite(*goal_at);
  Decision d = decide(Verdict::GOAL_KICK, Law::keeper_push_in, s,
                      "the keeper was pushed " + fixed(moved, 3) + " m towards its line in the " +
                          fixed(rules.push_in_s, 2) + " s before the goal");
  d.robots[index_of(team)] = attackers;
  d.add_robot(*keeper);
  return against(std::move(d), team, Restart::GOAL_KICK);
}

}  // namespace mirocup::referee
