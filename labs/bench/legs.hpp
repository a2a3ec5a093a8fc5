// SPDX-License-Identifier: MIT
//
// Whole legs of ten minutes, played by `mirocup match` as users play them.
#pragma once

#include <string>
#include <vector>

namespace mirocup::bench {

struct Leg {
  std::string name;
  double wall_seconds = 0.0;
  double cpu_seconds = 0.0;  // of the server and both teams; they share one core
  double played_seconds = 0.0;

  // Played time divided by processor time: 1 is real time.
  double speed() const { return played_seconds / cpu_seconds; }
};

// Plays the legs sandboxed and trusted by turns, `rounds` times, and returns the fastest of each.
// Empty if the program `mirocup` is not beside this one or a leg cannot be played.
std::vector<Leg> play_legs(int rounds);

}  // namespace mirocup::bench
