// SPDX-License-Identifier: MIT
//
// The project's own programs, run to be timed.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace mirocup::bench {

// A bench binds itself to one core; the programs that it runs may also use the others.
enum class Cores { this_one, all };

struct ProgramTimes {
  double wall_seconds = 0.0;
  double cpu_seconds = 0.0;  // with what it ran and waited for
};

// Waits for the program and discards its standard output. Returns nothing if it failed.
std::optional<ProgramTimes> run(std::vector<std::string> words, Cores cores);

}  // namespace mirocup::bench
