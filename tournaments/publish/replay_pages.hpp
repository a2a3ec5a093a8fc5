// SPDX-License-Identifier: MIT
//
// Makes a replay page for every leg that was played, by several `mirocup replay` processes at once.
// Pages have no measured times, so that they depend only on the play of the leg. A page that exists
// is kept, because a record never changes.
#pragma once

#include "tournaments/league/folder.hpp"

#include <string>

namespace mirocup::league {

// Returns the path, inside site/, of the page of a record ("records/x.json").
std::string replay_page_of(const std::string& record);

// Makes the missing pages with `jobs` processes at once (0: one for each processor). Returns the
// number of pages that could not be made; the league can be published without them.
Result<int> make_replay_pages(system::Files& files, const Folder& folder, const LeagueState& state,
                              int jobs);

}  // namespace mirocup::league
