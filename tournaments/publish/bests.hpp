// SPDX-License-Identifier: MIT
//
// What people talk about: the records of a league, and the legs that are worth watching.
#pragma once

#include "tournaments/publish/leg_view.hpp"

#include <string>
#include <vector>

namespace mirocup::league {

// One record: "Fastest goal", "4.2 s", "Orbit, robot 1", "against Lions, round 3, leg 2".
struct Best {
  std::string title;
  std::string value;
  std::string who;
  std::string where;
  std::string page;  // from the top of the site, "" if there is none; a replay at the moment
};

// Returns the records that the league has so far: fastest goal, biggest win, most goals in a leg,
// biggest upset, longest winning run, longest run without defeat, most goals of a robot, cleanest
// team.
std::vector<Best> bests_of(const Overview& overview);

struct WorthWatching {
  const LegView* leg = nullptr;
  std::string why;  // "the lead changed twice, decided 8 s before the end"
};

// Returns the most exciting legs, the best first: where the lead changed, that were decided late,
// close, full of goals, or won by the team that is weaker by far. `team`: only its legs; no_team:
// all.
std::vector<WorthWatching> worth_watching(const Overview& overview, int team, std::size_t most);

}  // namespace mirocup::league
