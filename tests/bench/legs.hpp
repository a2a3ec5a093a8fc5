// SPDX-License-Identifier: MIT
//
// Whole legs of ten minutes, played by `mirocup match` as users do it.
#pragma once

#include <string>
#include <vector>

namespace mirocup::bench {

struct Leg {
  std::string name;
  double wall_seconds = 0.0;
  double cpu_seconds = 0.0;  // of the server and both teams; they share one core
  double played_seconds = 0.0;

  // How many times as fast as the game itself, if the core were theirs alone.
  double speed() const { return played_seconds / cpu_seconds; }
};

// Sandboxed and trusted by turns, so many rounds; of each the fastest. Empty where the program
// `mirocup` is not beside this one or a leg cannot be played.
std::vector<Leg> play_legs(int rounds);

}  // namespace mirocup::bench
