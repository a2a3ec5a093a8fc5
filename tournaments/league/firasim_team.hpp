// SPDX-License-Identifier: MIT
//
// Entering a team that speaks FIRASim's protocol: the team hands in no library, so league.json
// describes it completely.
#pragma once

#include "tournaments/league/folder.hpp"

#include <cstdint>
#include <string>

namespace mirocup::league {

// Writes the team, whose source is "firasim:NAME", into league.json. Replaces a team of that name
// if the replaced team also speaks FIRASim's protocol. Returns a sentence that says why the team
// cannot enter; "" if it was written.
Result<std::string> enter_firasim_team(system::Files& files, const Folder& folder,
                                       const TeamConfig& team, std::int64_t now);

}  // namespace mirocup::league
