// SPDX-License-Identifier: MIT
//
// How strong an entry is, measured by the house teams.
#pragma once

#include "core/field/league.hpp"
#include "programs/check/leg_story.hpp"

#include <array>
#include <string>
#include <vector>

namespace mirocup::app {

// A house team, and the goals a minute by which it wins against `striker` in the three leagues.
struct Rung {
  const char* team;
  std::array<double, 3> lead;
};
// From the weakest to the strongest.
inline constexpr std::array<Rung, 7> ladder{{{"idle", {-3.7, -3.0, -3.0}},
                                             {"keeper", {-0.4, -0.4, -0.4}},
                                             {"chaser", {-0.3, -0.3, -0.3}},
                                             {"striker", {0.0, 0.0, 0.0}},
                                             {"navigator", {0.35, 0.5, 0.5}},
                                             {"tactician", {0.7, 0.8, 0.8}},
                                             {"planner", {2.6, 2.6, 2.6}}}};

struct Strength {
  std::string text;  // a sentence; "" if the legs are too short to tell
  bool is_below_idle = false;
  bool may_be_idle = false;  // true: not clearly stronger than a team that stands
};

// Judges an entry by its legs against house teams: some against `striker`, perhaps some against
// each.
Strength strength_of(const std::vector<LegStory>& legs, League league);

}  // namespace mirocup::app
