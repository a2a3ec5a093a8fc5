// SPDX-License-Identifier: MIT
//
// The bests of a league, such as its fastest goal, and the legs that are worth watching.
#pragma once

#include "tournaments/publish/leg_view.hpp"

#include <string>
#include <vector>

namespace mirocup::league {

// A best: "Fastest goal", "4.2 s", "Orbit, robot 1", "against Lions, round 3, leg 2".
struct Best {
  std::string title;
  std::string value;
  std::string who;
  std::string where;
  std::string page;  // link from the top of the site to the moment in the replay; "": none
};

// Returns the bests of the league so far: fastest goal, biggest win, most goals in a leg, biggest
// upset, longest winning run, longest run without defeat, most goals of a robot, cleanest team.
std::vector<Best> bests_of(const Overview& overview);

struct WorthWatching {
  const LegView* leg = nullptr;
  std::string why;  // "the lead changed twice, decided 8 s before the end"
};

// Returns the most exciting legs, the best first, at most one of each fixture: legs with changes of
// the lead, with a late decision, with a close score, with many goals, or won by the far weaker
// team. Only legs of `team` count; no_team: legs of all teams.
std::vector<WorthWatching> worth_watching(const Overview& overview, int team, std::size_t most);

}  // namespace mirocup::league
