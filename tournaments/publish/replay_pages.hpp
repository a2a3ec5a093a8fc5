// SPDX-License-Identifier: MIT
//
// A replay page for every leg that was played: `mirocup replay` makes them, some at once, without
// measured times, so that a page depends on what was decided only. A page that is there already is
// not made again; its record does not change.
#pragma once

#include "tournaments/league/folder.hpp"

#include <string>

namespace mirocup::league {

// The page of a record ("records/x.json"), inside site/.
std::string replay_page_of(const std::string& record);

// As many at once as there are jobs (0: one for each processor). Returns how many could not be
// made, which does not keep a league from being published.
Result<int> make_replay_pages(system::Files& files, const Folder& folder, const LeagueState& state,
                              int jobs);

}  // namespace mirocup::league
