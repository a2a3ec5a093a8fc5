// SPDX-License-Identifier: MIT
//
// The program in whose process a team plays.
#pragma once

#include "core/base/error.hpp"
#include "mirocup/strategy.h"
#include "plugins/host/plugin.hpp"
#include "plugins/host/sealed_entry.hpp"

#include <string>

namespace mirocup::plugins {

enum class Care { none, watched };  // watched: the program looks for mistakes in the use of memory

// Returns the path of the program that plays an entry. For a team in Python `care` has no effect,
// because Python itself checks memory. Errors: Errc::unavailable if the program that plays Python
// is not built or installed.
Result<std::string> host_program(const SealedEntry& entry, Care care = Care::none);

// Returns the path of the module with which --trusted plays Python. Errors are those of the
// function above.
Result<std::string> python_module();

// The exports of mirocup-python.so, for teams in Python that play in the calling process: with
// `mirocup match --trusted` and `mirocup join`.

struct PythonLoaded {
  const mirocup_strategy* strategy;
  void* team;     // null: the file is not a team, or its team cannot be created
  char why[256];  // if `team` is null, a sentence with the reason
  char cause[64];
  int line;  // Fault::line
};

// Loads the file of a team and creates the team. `setup` must outlive the team. Must be called from
// the thread that plays. The team's functions throw the exceptions that a team in Python raises.
extern "C" void mirocup_python_load(const char* path, const mirocup_setup* setup,
                                    PythonLoaded* loaded);

// Loads mirocup-python.so from `module`, and then with this module the team's file at `path`.
// `setup` must outlive the plugin.
tl::expected<Plugin, match::Fault> load_python(const std::string& path, const std::string& module,
                                               const mirocup_setup& setup);

}  // namespace mirocup::plugins
