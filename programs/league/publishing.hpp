// SPDX-License-Identifier: MIT
//
// Parts of the subcommands that publish a league: `publish`, `start`, `nightly`, and acts that
// change the pages.
#pragma once

#include "tournaments/league/gaps.hpp"
#include "tournaments/publish/night.hpp"
#include "tournaments/publish/replay_pages.hpp"

#include <functional>
#include <optional>
#include <string>

namespace mirocup::league {

// Returns the last night that visitors may see on pages that show `shown`: the whole league, or its
// released part.
Result<std::optional<Night>> night_for(const LeagueState& shown, const LeagueStore& store);

// Returns the function that makes the page in which visitors play by hand; null if the module for
// browsers was not built. `files` must outlive the function.
std::function<std::string()> playground_maker(system::Files& files);

// Returns the files beside the replay pages of this program. They lack the module if it was not
// built.
PageParts page_parts(system::Files& files);

// Returns the media type of a file of a site, by the ending of its path.
std::string type_of(const std::string& path);

// Prints to standard error what journal and files of the league lack, and returns it.
Result<Gaps> say_gaps(system::Files& files, const LeagueStore& store);

// Opens the league and writes the pages of its released part; `jobs` replay pages are made at once
// (0: one for each processor). Returns exit_no, and prints why, if a leg lacks its page or its
// numbers, if the pages lack a leg whose record differs from its replay, or if something else is
// missing. If the journal has lost lines, the pages stay as they are.
Result<int> publish_league(system::Files& files, const Folder& folder, int jobs = 0);

}  // namespace mirocup::league
