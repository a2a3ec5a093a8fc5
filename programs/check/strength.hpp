// SPDX-License-Identifier: MIT
//
// How strong an entry is, measured by the house teams.
#pragma once

#include "core/field/league.hpp"
#include "programs/check/leg_story.hpp"

namespace mirocup::app {

// A house team, and the goals a minute by which it wins against `striker` in the three leagues.
struct Rung {
  const char* team;
  std::array<double, 3> lead;
};
// From the weakest to the strongest. The means of six legs with halves of 150 s, without the mercy
// rule; those of the strongest two in the large league are estimates.
inline constexpr std::array<Rung, 7> ladder{{{"idle", {-3.6, -3.45, -3.05}},
                                             {"keeper", {-0.33, -0.3, -0.3}},
                                             {"chaser", {-0.33, -0.03, -0.59}},
                                             {"striker", {0.0, 0.0, 0.0}},
                                             {"navigator", {0.33, 0.33, 0.8}},
                                             {"tactician", {0.69, 0.4, 1.0}},
                                             {"planner", {2.97, 2.21, 2.5}}}};

struct Strength {
  std::string text;  // a sentence; "" if the legs are too short to tell
  bool is_below_idle = false;
  bool is_below_keeper = false;  // true: clearly weaker than the weakest house team that plays
};

// Judges an entry by its legs against house teams: some against `striker`, perhaps some against
// each.
Strength strength_of(const std::vector<LegStory>& legs, RobotLeague league);

}  // namespace mirocup::app
