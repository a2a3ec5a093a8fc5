// SPDX-License-Identifier: MIT
//
// The exports of mirocup-python.so, for teams in Python that play in the calling process: with
// `mirocup match --trusted` and `mirocup join`.
#pragma once

#include "mirocup/strategy.h"
#include "plugins/host/plugin.hpp"

#include <string>

namespace mirocup::plugins {

struct PythonLoaded {
  const mirocup_strategy* strategy;
  void* team;     // null: the file is not a team, or its team cannot be created
  char why[256];  // if `team` is null, a sentence with the reason
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
