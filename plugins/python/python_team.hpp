// SPDX-License-Identifier: MIT
//
// A team that is written in Python, played by an interpreter in this process. The team's class
// derives from mirocup.team.Team. The text of that module (plugins/python/team.py) is part of the
// program, so that a team needs only the system's Python.
//
// The team has the form of the functions of strategy.h, so host and match treat it like a library.
// An exception that leaves a method of the class leaves the function as a std::runtime_error.
#pragma once

#include "core/match/controller.hpp"
#include "mirocup/strategy.h"

#include <tl/expected.hpp>

#include <string>
#include <string_view>

namespace mirocup::python {

enum class Surrounding {
  sandbox,    // output goes to the team's log, and is dropped if the log is full
  developer,  // uses input and output of this process, so that a debugger works
};

struct LoadedTeam {
  const mirocup_strategy* strategy = nullptr;
  void* team = nullptr;  // argument of the strategy's functions; valid until destroy()
};

// Starts the interpreter if this process has none yet, runs the text of the file and creates its
// team. `name` is the name of the file in sentences and tracebacks. `setup` must outlive the team.
// The interpreter hashes texts in the same way in every leg, and imports only from the folders of
// its own library. Errors are the team's: no_load if the file is not a team, crash if the team
// cannot be created. From this call on only the calling thread may use the team.
tl::expected<LoadedTeam, match::Fault> load_team(const std::string& text, const std::string& name,
                                                 const mirocup_setup& setup,
                                                 Surrounding surrounding);

// Returns the text of the file `name` that is part of the program, mirocup/team.py; "" if the
// program lacks the file.
std::string_view team_source(std::string_view name);

}  // namespace mirocup::python
