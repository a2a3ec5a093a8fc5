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

// A league that this process alone plays, as long as it holds the lock.
struct HeldLeague {
  LeagueStore store;
  system::FileLock lock;
};

// Opens a league in order to play it, and prints any repair of its journal. Errors: those of
// expect_owner(); Errc::unavailable if another process plays it, with `advice` as the end of the
// sentence.
Result<HeldLeague> hold_league(system::Files& files, const Folder& folder,
                               const std::string& advice);

// How a league is played.
struct PlayTerms {
  std::string engine = "local";        // or "slurm"
  int jobs = 0;                        // legs at once; 0: one for each processor
  bool watched = false;                // league serve shows the legs of this host
  int dds_domain = 0;                  // for legs with teams over DDS
  bool accepts_other_program = false;  // continues a league that another program began
};

// Plays until no leg can be played, and returns the state. Errors are also those of
// expect_program().
Result<LeagueState> play_league(system::Files& files, LeagueStore store, ProgressReporter& progress,
                                const PlayTerms& terms);

// The option --other-program of these subcommands.
void add_other_program(const system::Command& command, bool& accepts_other_program);

// Prints to standard error why the league has not ended.
void say_what_is_left(const LeagueState& state);

}  // namespace mirocup::league
