// SPDX-License-Identifier: MIT
//
// The links from a replay page to its league, and the names of its teams. A page is made once, but
// its links change while the league is played, and display names may change at any time. The links
// are between two marker comments in the page.
#pragma once

#include "tournaments/publish/leg_view.hpp"

#include <string>

namespace mirocup::league {

// Returns the replay page of a record with links to the front page, the round, both teams and the
// legs before and after, and a note if the leg does not count; title, scoreboard and calls have the
// display names of the teams. `record` is the path inside the league folder. A page without the
// comments is returned unchanged.
std::string with_league_links(std::string page, const Overview& overview,
                              const std::string& record);

}  // namespace mirocup::league
