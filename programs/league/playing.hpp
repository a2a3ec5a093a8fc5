// SPDX-License-Identifier: MIT
//
// Parts of the subcommands that play a league: `start` and `nightly`.
#pragma once

#include "system/commands.hpp"
#include "system/file_lock.hpp"
#include "tournaments/league/league_store.hpp"
#include "tournaments/play/progress_reporter.hpp"

#include <string>

namespace mirocup::league {

// A league that this process alone plays as long as this object holds the lock.
struct HeldLeague {
  LeagueStore store;
  system::FileLock lock;
};

// Opens a league in order to play it, and prints any repair of its journal. Errors are those of
// expect_owner(), and Errc::unavailable if another process plays the league; `advice` is the end of
// that error's sentence.
Result<HeldLeague> hold_league(system::Files& files, const Folder& folder,
                               const std::string& advice);

// The settings with which a league is played.
struct PlayTerms {
  std::string engine = "local";  // "local" or "slurm"
  int jobs = 0;                  // legs at once; 0: a leg for each processor
  bool watched = false;          // true: league serve shows the legs of this host
  int dds_domain = 0;            // the DDS domain of legs with teams over DDS
};

// A league after play_league(), and the number of records from elsewhere that differ from their
// replays, so that their legs were void.
struct PlayedLeague {
  LeagueState state;
  int refused = 0;
};

// Plays until no leg can be played. Errors include those of expect_program().
Result<PlayedLeague> play_league(system::Files& files, LeagueStore store,
                                 ProgressReporter& progress, const PlayTerms& terms);

// Prints to standard error why the league has not ended.
void say_what_is_left(const LeagueState& state);

}  // namespace mirocup::league
