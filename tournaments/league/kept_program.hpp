// SPDX-License-Identifier: MIT
//
// The copies of match servers in the folder of a league: each program that has played it. What a
// leg looked like is known to the program that played it only: another one may go another way from
// the same commands.
#pragma once

#include "tournaments/league/folder.hpp"

#include <string>

namespace mirocup::league {

// The path at which the copy of the match server of that behaviour (`game` in records) is kept.
std::string kept_program(const Folder& folder, const std::string& game);

// Returns the path of the match server that simulates records of that behaviour again: the kept
// one, or that of this program if it behaves alike or none is kept.
std::string program_of_game(system::Files& files, const Folder& folder, const std::string& game);

// Returns the behaviour of the program that played a record, a path inside the folder; "" if the
// record cannot be read, or is from before it was written down.
Result<std::string> game_of_record(system::Files& files, const Folder& folder,
                                   const std::string& record);

}  // namespace mirocup::league
