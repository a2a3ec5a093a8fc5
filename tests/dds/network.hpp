// SPDX-License-Identifier: MIT
//
// What the tests of teams on the network share.
#pragma once

#include "tests/support/program.hpp"

#include <string>
#include <unistd.h>
#include <vector>

namespace mirocup::test_support {

// Matches of tests that run at the same time must not meet.
inline std::string match_id(const std::string& name) {
  return name + "-" + std::to_string(getpid());
}

// The command line of a house team, or the library at a path, that joins a match.
inline std::vector<std::string> join(const std::string& id, const std::string& colour,
                                     const std::string& name, const std::string& team) {
  const std::string library =
      team.find('/') == std::string::npos ? program("house/" + team + ".so") : team;
  return {program("mirocup"), "join", "--match", id, "--team", colour, "--name", name, library};
}

}  // namespace mirocup::test_support
