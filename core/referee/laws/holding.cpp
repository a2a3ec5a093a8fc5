// SPDX-License-Identifier: MIT
#include "core/referee/laws/holding.hpp"

#include "core/referee/touches.hpp"

namespace mirocup::referee {

bool hides_ball(const JudgedField& pitch, const TickFacts& s, const RobotId& robot) {
  return s.touches_ball(robot) && ball_gap(pitch, s.ball, s.pose(robot)) < -pitch.rules.hide_m;
}

std::optional<Decision> judge_holding(const JudgedField& pitch, const TickFacts& s,
                                      const Occupancy& occupancy, HoldingMemory& memory) {
  std::optional<Decision> called;
  for (const End end : ends_from_ball(s)) {
    const int e = index_of(end);
    for (int i = 0; i < pitch.field.robots_per_team; ++i) {
      const RobotId robot{end, i};
      const bool keeps =
          occupancy.keeper[e] == robot || (i == 0 && occupancy.penalty_area[e][e][i]);
      Dwell& hides = memory.hides[e][i];
      hides.sample(!keeps && hides_ball(pitch, s, robot), s.duration);
      if (called || !hides.reached(pitch.rules.hide_s, s.duration)) continue;
      called = decide(Verdict::FREE_BALL, Law::holding, s,
                      name_of(robot) + " held the ball more than " + fixed(pitch.rules.hide_m, 4) +
                          " m inside its outline for " + fixed(hides.for_s, 2) + " s");
      give_free_ball(pitch, s.ball, *called);
      called->team = end;
      called->add_robot(robot);
    }
  }
  return called;
}

}  // namespace mirocup::referee
