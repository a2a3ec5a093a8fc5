// SPDX-License-Identifier: MIT
//
// The subcommands of mirocup-labs, which `mirocup` calls by their names. Each has one source, which
// declares its options and does its work. A run returns the exit code of an answer, exit_yes or
// exit_no, or an error.
#pragma once

#include "system/commands.hpp"

#include <string>
#include <vector>

namespace mirocup::labs {

// The headings of the help.
inline constexpr const char* for_teams = "A team";
inline constexpr const char* for_engineers = "Pitches and physics";

// Each declares its subcommand.
using Add = void(system::Commands& commands);
Add add_export, add_identify, add_new, add_record_as_seen, add_tune, add_validate;

// Runs mirocup-bench, the only program that is linked to other engines, in the place of this
// process. Returns only if it cannot be run.
Error become_bench(std::vector<std::string> arguments);

}  // namespace mirocup::labs
