// SPDX-License-Identifier: MIT
//
// Starts the process of a team: the process gets five descriptors and a fixed environment, and
// nothing else of the server.
#pragma once

#include "core/base/error.hpp"
#include "plugins/host/child.hpp"
#include "plugins/host/sandbox/isolation.hpp"

#include <string>

namespace mirocup::plugins {

// The numbers of the descriptors in the team's process. Standard input is /dev/null; standard
// output and standard error are the log.
enum HostDescriptor : int {
  observation_descriptor = 3,
  command_descriptor = 4,
  setup_descriptor = 5,  // to report that the sandbox is complete, or why it is not
  entry_descriptor = 6,
  program_descriptor = 7,  // the program; closed by exec
};

// The byte that the process writes to setup_descriptor, a socket of packets, when the sandbox is
// complete. A packet with the descriptor of ask_before_loading() may come before this byte. Any
// other text is the reason why the sandbox is not complete.
inline constexpr char sandbox_stands = '+';

// The programs of a team's process: for libraries, for libraries in which `mirocup check` looks for
// mistakes, and for teams in Python.
inline constexpr const char* library_host = "mirocup-plugin-host";
inline constexpr const char* careful_host = "mirocup-careful-host";
inline constexpr const char* python_host = "mirocup-python-host";

struct Launch {
  std::string program;  // path of a program of the list above
  Isolation isolation = Isolation::T2;
  bool fixed_addresses = true;  // see surroundings.hpp
  // Descriptors of the calling process, which keeps their ownership.
  int observation = -1;
  int command = -1;
  int setup = -1;
  int entry = -1;
  int log = -1;
};

// Starts the process without waiting for its sandbox. Errors: Errc::unavailable.
Result<Child> launch(const Launch& what);

}  // namespace mirocup::plugins
