// SPDX-License-Identifier: MIT
//
// Parts of the subcommands that publish a league: `publish`, `start`, `nightly`, and acts that
// change its pages.
#pragma once

#include "tournaments/league/league_store.hpp"
#include "tournaments/publish/night.hpp"

#include <functional>
#include <optional>
#include <string>

namespace mirocup::league {

// What pages say of nights: the last one that may be told, and the feed.
struct NightNews {
  std::optional<Night> night;
  std::string feed;  // feed.xml; ""
};

// Returns the news for the pages that show `shown`, which is all of the league or what is released
// of it.
Result<NightNews> news_for(const LeagueState& shown, const LeagueStore& store);

// Returns what makes the page in which visitors play by hand; null if its module was not built.
// `files` outlives it.
std::function<std::string()> playground_maker(system::Files& files);

// Writes the pages of a state to the folder's site/; `jobs` replay pages are made at once (0: one
// for each processor).
Result<void> publish_site(system::Files& files, const Folder& folder, const LeagueState& shown,
                          const NightNews& news, int jobs = 0);

// Opens the league and writes the pages of what is released.
Result<void> publish_league(system::Files& files, const Folder& folder, int jobs = 0);

// Prints what is known of the teams and their entries.
Result<void> print_roster(system::Files& files, const LeagueStore& store, bool is_json);

}  // namespace mirocup::league
