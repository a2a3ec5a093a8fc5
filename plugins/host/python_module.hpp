// SPDX-License-Identifier: MIT
//
// What mirocup-python.so exports, for teams in Python that play in the server's process.
#pragma once

#include "mirocup/strategy.h"

namespace mirocup::plugins {

struct PythonLoaded {
  const mirocup_strategy* strategy;
  void* team;     // null: the file is no team, or its team cannot be created
  char why[256];  // then a sentence
};

// Loads the file of a team and creates the team. `setup` must outlive it. Must be called from the
// thread that plays. The team's functions throw what a team in Python raises.
extern "C" void mirocup_python_load(const char* path, const mirocup_setup* setup,
                                    PythonLoaded* loaded);

}  // namespace mirocup::plugins
