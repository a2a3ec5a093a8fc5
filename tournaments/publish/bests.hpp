// SPDX-License-Identifier: MIT
//
// The bests of a league, such as its fastest goal, and the legs that are worth watching.
#pragma once

#include "tournaments/publish/leg_view.hpp"

#include <string>

namespace mirocup::league {

// Returns a best as values of a template: {title, value, who, where, page}, such as "Fastest goal",
// "4.2 s", "Orbit, robot 1", "against Lions, round 3, leg 2". `page` is the link from the top of
// the site to the moment in the replay; "": none.
Json best(const std::string& title, const std::string& value, const std::string& who,
          const std::string& where, const std::string& page);

// Returns the bests of the league so far: fastest goal, biggest win, most goals in a leg, biggest
// upset, longest winning run, longest run without defeat, most goals of a robot, cleanest team.
Json bests_of(const Overview& overview);

// Returns the most exciting legs as leg_values(), the best first, at most one of each fixture:
// legs with changes of the lead, with a late decision, with a close score, with many goals, or
// won by the far weaker team.
Json worth_watching(const Overview& overview);

}  // namespace mirocup::league
