// SPDX-License-Identifier: MIT
//
// The project's own programs, run to be timed.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace mirocup::bench {

// A bench keeps itself to one core; what it runs may have the others, too.
enum class Cores { this_one, all };

struct ProgramTimes {
  double wall_seconds = 0.0;
  double cpu_seconds = 0.0;  // with what it ran and waited for
};

// Waits for the program, whose standard output nobody sees. Nothing if it failed.
std::optional<ProgramTimes> run(std::vector<std::string> words, Cores cores);

}  // namespace mirocup::bench
