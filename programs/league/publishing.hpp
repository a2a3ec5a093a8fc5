// SPDX-License-Identifier: MIT
//
// Parts of the subcommands that play and publish a league: `start`, `nightly`, `publish`.
#pragma once

#include "system/commands.hpp"
#include "tournaments/league/league_store.hpp"
#include "tournaments/play/progress_reporter.hpp"
#include "tournaments/publish/night.hpp"

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

// Writes the pages of a state to the folder's site/; `jobs` replay pages are made at once (0: one
// for each processor).
Result<void> publish_site(system::Files& files, const Folder& folder, const LeagueState& shown,
                          const NightNews& news, int jobs = 0);

// Opens the league and writes the pages of what is released.
Result<void> publish_league(system::Files& files, const Folder& folder, int jobs = 0);

// How a league is played.
struct PlayTerms {
  std::string engine = "local";        // or "slurm"
  int jobs = 0;                        // legs at once; 0: one for each processor
  bool watched = false;                // league serve shows the legs of this host
  int dds_domain = 0;                  // of the legs in which a team plays over DDS
  bool accepts_other_program = false;  // than the one that has played until now
};

// Plays until no leg can be played, and returns the state. Errors are also those of
// expect_program().
Result<LeagueState> play_league(system::Files& files, LeagueStore store, ProgressReporter& progress,
                                const PlayTerms& terms);

// The option --other-program of those that play.
void add_other_program(const system::Command& command, bool& accepts_other_program);

// Prints to standard error what keeps the league from its end.
void say_what_is_left(const LeagueState& state);

// Prints what is known of the teams and their entries.
Result<void> print_roster(system::Files& files, const LeagueStore& store, bool is_json);

}  // namespace mirocup::league
