// SPDX-License-Identifier: MIT
//
// Crowded areas: four laws that are one rule with different numbers. Too many robots of one team
// stand in a goal area or a penalty area for too long while the ball is near that goal.
//
// | law            | source             | robots of     | area         | restart      |
// | two_defenders  | MiroSot 8.4, 11.1  | the owner     | goal area    | penalty kick |
// | four_defenders | MiroSot 8.9, 11.4  | the owner     | penalty area | penalty kick |
// | two_attackers  | MiroSot 8.3, 12.2  | the opponents | goal area    | goal kick    |
// | four_attackers | simulated leagues  | the opponents | penalty area | goal kick    |
//
// The rules say how many robots may be in the area (a limit of 0 switches the law off), for how
// long one more is forgiven, and whether two more are called at once. The small league has no
// penalty area, so the laws of four never apply to it.
//
// The time is counted wherever the ball is, so that robots cannot park in an area; the call comes
// when the ball is in the zone of that goal (ball_in_zone()). A robot that was pushed into the area
// does not count.
#pragma once

#include "core/referee/dwell.hpp"
#include "core/referee/laws/law.hpp"
#include "core/referee/occupancy.hpp"

#include <array>

namespace mirocup::referee {

// The four laws; their names are those of the Law that the decision carries.
enum class CrowdingLaw { two_defenders, four_defenders, two_attackers, four_attackers };

struct CrowdingMemory {
  // The time for which each area has been crowded: [law][index_of(the end whose area it is)].
  std::array<ByEnd<Dwell>, 4> crowded;

  const ByEnd<Dwell>& of(CrowdingLaw law) const { return crowded[static_cast<std::size_t>(law)]; }
  ByEnd<Dwell>& of(CrowdingLaw law) { return crowded[static_cast<std::size_t>(law)]; }
};

// Judges one of the four laws. `goal_at` is the end whose goal line the ball crosses in this tick:
// for the laws about attackers such a ball counts as in the zone, wherever it came from. The calls
// of the laws about defenders ignore the advantage: judge_play() lets them wait for it.
std::optional<Decision> judge_crowding(CrowdingLaw law, const JudgedField& pitch,
                                       const TickFacts& situation, const Occupancy& occupancy,
                                       std::optional<End> goal_at, CrowdingMemory& memory);

}  // namespace mirocup::referee
