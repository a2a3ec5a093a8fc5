// SPDX-License-Identifier: MIT
#include "core/referee/laws/crowding.hpp"

#include "core/base/assert.hpp"

#include <utility>

namespace mirocup::referee {

namespace {

// One row of the table in the header.
struct Row {
  CrowdingLaw which;
  Law law;
  ByEnd<ByEnd<RobotSet>> Occupancy::*area;
  bool by_owner;           // the robots that are counted are the defenders, whose area it is
  int Rules::*max_robots;  // 0: any number
  bool Rules::*at_once;    // two robots too many may not stay at all; null: they may
  const char* text;        // of the reason, after the number of robots
};

constexpr std::array<Row, 4> rows{{
    {.which = CrowdingLaw::two_defenders,
     .law = Law::two_defenders,
     .area = &Occupancy::goal_area,
     .by_owner = true,
     .max_robots = &Rules::def_max,
     .at_once = &Rules::def_at_once,
     .text = " defenders in their goal area for "},
    {.which = CrowdingLaw::four_defenders,
     .law = Law::four_defenders,
     .area = &Occupancy::penalty_area,
     .by_owner = true,
     .max_robots = &Rules::pa_def_max,
     .at_once = &Rules::def_at_once,
     .text = " defenders in their penalty area for "},
    {.which = CrowdingLaw::two_attackers,
     .law = Law::two_attackers,
     .area = &Occupancy::goal_area,
     .by_owner = false,
     .max_robots = &Rules::att_max,
     .at_once = &Rules::att_at_once,
     .text = " attackers in the goal area for "},
    {.which = CrowdingLaw::four_attackers,
     .law = Law::four_attackers,
     .area = &Occupancy::penalty_area,
     .by_owner = false,
     .max_robots = &Rules::pa_att_max,
     .at_once = nullptr,
     .text = " attackers in the penalty area for "},
}};

std::string reason_of(const Row& row, const TickFacts& s, const RobotSet& robots, double seconds) {
  const std::string crowd =
      std::to_string(robots.count()) + row.text + fixed(seconds, 2) + " s, the ball ";
  if (row.area != &Occupancy::goal_area) return crowd + "in it";
  return crowd + "at x = " + fixed(s.ball.x(), 3) + " m, y = " + fixed(s.ball.y(), 3) + " m";
}

}  // namespace

std::optional<Decision> judge_crowding(CrowdingLaw law, const JudgedField& pitch,
                                       const TickFacts& s, const Occupancy& occupancy,
                                       std::optional<End> goal_at, CrowdingMemory& memory) {
  const Row& row = rows[static_cast<std::size_t>(law)];
  MIROCUP_ASSERT(row.which == law);
  const int max_robots = pitch.rules.*row.max_robots;
  std::optional<Decision> called;
  for (const End owner : ends_from_ball(s)) {
    Dwell& crowded = memory.of(law)[index_of(owner)];
    const End team = row.by_owner ? owner : opposite(owner);
    const RobotSet robots = not_pushed(occupancy, occupancy.*row.area, owner, team);
    const int count = static_cast<int>(robots.count());
    crowded.sample(max_robots > 0 && count > max_robots, s.duration);
    const bool goal_counts = !row.by_owner && goal_at == owner;
    const bool at_once =
        (row.at_once != nullptr && pitch.rules.*row.at_once && count > max_robots + 1) ||
        (goal_counts && pitch.rules.att_cancels_goal && law == CrowdingLaw::two_attackers);
    const double dwell_s = row.by_owner ? pitch.rules.def_dwell_s : pitch.rules.att_dwell_s;
    const double max_s = at_once ? 0.0 : dwell_s;
    if (called || !crowded.reached(max_s, s.duration)) continue;
    if (!ball_in_zone(pitch, s, owner) && !goal_counts) continue;
    const auto [verdict, restart] = row.by_owner
                                        ? std::pair(Verdict::PENALTY_KICK, Restart::PENALTY_KICK)
                                        : std::pair(Verdict::GOAL_KICK, Restart::GOAL_KICK);
    Decision d = decide(verdict, row.law, s, reason_of(row, s, robots, crowded.for_s));
    d.robots[index_of(team)] = robots;
    called = against(std::move(d), team, restart);
  }
  return called;
}

}  // namespace mirocup::referee
