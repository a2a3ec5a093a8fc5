// SPDX-License-Identifier: MIT
//
// Entering a team that speaks FIRASim's protocol: it hands in no library, so league.json describes
// it completely.
#pragma once

#include "tournaments/league/folder.hpp"

#include <cstdint>
#include <string>

namespace mirocup::league {

// Writes the team, whose source is "firasim:NAME", into league.json; a team of that name is
// replaced if it is of the same kind. Returns a sentence that says why this is impossible; "" if it
// is done.
Result<std::string> enter_firasim_team(system::Files& files, const Folder& folder,
                                       const TeamConfig& team, std::int64_t now);

}  // namespace mirocup::league
