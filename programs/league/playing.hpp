// SPDX-License-Identifier: MIT
//
// Parts of the subcommands that play a league: `start`, `nightly` and `close --final`.
#pragma once

#include "system/commands.hpp"
#include "system/file_lock.hpp"
#include "tournaments/play/runner.hpp"

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
struct PlayTerms : RunOptions {
  std::string engine = "local";  // "local" or "slurm"
};

// Adds the option --nat.
void add_nat(const system::Command& command, PlayTerms& terms);

// A league after play_and_publish().
struct PlayedLeague {
  LeagueState state;
  // The number of records from elsewhere that differ from their replays, so that their legs were
  // void.
  int refused = 0;
  int published = 0;  // what publish_league() has returned
};

// Plays until no leg can be played, and makes the pages. Errors include those of expect_program().
Result<PlayedLeague> play_and_publish(system::Files& files, LeagueStore store,
                                      const PlayTerms& terms);

// Returns the exit code of a command that has played. If legs are left in `now`, prints to standard
// error why the league has not ended.
int exit_code_of(const PlayedLeague& played, const LeagueState& now);

}  // namespace mirocup::league
