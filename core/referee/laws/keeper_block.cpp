// SPDX-License-Identifier: MIT
#include "core/referee/laws/keeper_block.hpp"

#include "core/referee/touches.hpp"

namespace mirocup::referee {

namespace {

// True if a team-mate of the keeper pushes the attacker, which does not push back.
bool is_kept_there(const JudgedField& pitch, const TickFacts& s, const RobotId& attacker,
                   const RobotId& keeper) {
  for (int j = 0; j < pitch.field.robots_per_team; ++j) {
    const RobotId mate{keeper.end, j};
    if (mate == keeper || !s.touch(attacker, j)) continue;
    if (drives_at(pitch, s, mate, attacker) && !drives_at(pitch, s, attacker, mate)) return true;
  }
  return false;
}

bool blocks(const JudgedField& pitch, const TickFacts& s, const RobotId& attacker,
            const RobotId& keeper) {
  const Rules& rules = pitch.rules;
  const Pose& a = s.pose(attacker);
  const Pose& k = s.pose(keeper);
  const double far = rules.block_ball_m * rules.block_ball_m;
  if ((a.position - s.ball).squaredNorm() <= far || (k.position - s.ball).squaredNorm() <= far) {
    return false;
  }
  return robot_gap(pitch, a, k, rules.block_gap_m) <= rules.block_gap_m &&
         drives_at(pitch, s, keeper, attacker) && !is_kept_there(pitch, s, attacker, keeper);
}

}  // namespace

std::optional<Decision> judge_keeper_block(const JudgedField& pitch, const TickFacts& s,
                                           const Occupancy& occupancy, KeeperBlockMemory& memory) {
  const Rules& rules = pitch.rules;
  if (rules.block_s == off) return std::nullopt;
  std::optional<Decision> called;
  for (const End end : ends_from_ball(s)) {
    const std::optional<RobotId>& keeper = occupancy.keeper[index_of(end)];
    const End team = opposite(end);
    for (int i = 0; i < pitch.field.robots_per_team; ++i) {
      const RobotId attacker{team, i};
      Dwell& standing = memory.blocks[index_of(team)][i];
      standing.sample(keeper && ball_in_half(s, end) && blocks(pitch, s, attacker, *keeper),
                      s.duration);
      if (called || !standing.reached(rules.block_s, s.duration)) continue;
      called =
          decide(Verdict::GOAL_KICK, Law::keeper_block, s,
                 name_of(attacker) + " stood in the keeper's way for " + fixed(standing.for_s, 2) +
                     " s, the ball more than " + fixed(rules.block_ball_m, 2) + " m away");
      called->add_robot(attacker);
      called->add_robot(*keeper);
      called = against(*std::move(called), team, Restart::GOAL_KICK);
    }
  }
  return called;
}

}  // namespace mirocup::referee
