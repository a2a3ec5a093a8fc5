// SPDX-License-Identifier: MIT
//
// The sources that the teams of a league have handed in, in folders for JPlag: OUT/submissions has
// a folder for each team, and OUT/base has the files that every team was given.
#pragma once

#include "tournaments/league/league_store.hpp"

#include <string>

namespace mirocup::league {

// Returns the text of a file that the build compiles into the program: README.md.
std::string_view given_file(std::string_view name);

// Writes the sources of the entries that play, or will play next, into a new or empty folder that
// only this user can read, and prints a line for each team. Errors: Errc::input if the folder is
// not empty.
Result<void> export_sources(system::Files& files, const LeagueStore& store,
                            const std::string& output);

}  // namespace mirocup::league
