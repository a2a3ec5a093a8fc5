// SPDX-License-Identifier: MIT
//
// Starts the process of a team: mirocup-plugin-host with a handful of descriptors, an environment
// of its own and nothing else of the server.
#pragma once

#include "core/base/error.hpp"
#include "plugins/host/child.hpp"
#include "plugins/host/sandbox/isolation.hpp"

#include <string>

namespace mirocup::plugins {

// The numbers that the team's process finds its descriptors under. Input, output and error output
// are nothing and the log.
enum HostDescriptor : int {
  observation_descriptor = 3,
  command_descriptor = 4,
  setup_descriptor = 5,  // where it says that the sandbox stands, or why not
  entry_descriptor = 6,
  program_descriptor = 7,  // closed by exec
};

// What it writes to setup_descriptor when the sandbox stands; anything else is why it doesn't.
inline constexpr char sandbox_stands = '+';

struct Launch {
  std::string program;  // path of mirocup-plugin-host
  Isolation isolation = Isolation::T2;
  // Descriptors of this process.
  int observation = -1;
  int command = -1;
  int setup = -1;
  int entry = -1;
  int log = -1;
};

Result<Child> launch(const Launch& what);

}  // namespace mirocup::plugins
