// SPDX-License-Identifier: MIT
//
// Decides which of the arriving commands is driven: the first one that answers the present tick.
// All others are counted by kind and thrown away.
#pragma once

#include <cstdint>
#include <optional>

namespace mirocup::dds {

struct CommandCounts {
  std::uint64_t in_step = 0;    // answered the present tick; at most one for each tick
  std::uint64_t late = 0;       // answered a tick that was over
  std::uint64_t duplicate = 0;  // answered the last answered tick again
  std::uint64_t ahead = 0;      // answered a tick that has not begun
  std::uint64_t foreign = 0;    // from another process than the team's
};

class Inbox {
 public:
  // Sets the present tick: an answer to it is in step.
  void expect(std::uint32_t tick) { expected_ = tick; }

  void count_foreign() { ++counts_.foreign; }

  // Counts a command of the team's own process. Returns true if it is the answer to the present
  // tick.
  bool accept(std::uint32_t tick) {
    if (tick == answered_) {
      ++counts_.duplicate;
    } else if (tick < expected_) {
      ++counts_.late;
    } else if (tick > expected_) {
      ++counts_.ahead;
    } else {
      answered_ = tick;
      ++counts_.in_step;
      return true;
    }
    return false;
  }

  // Returns the number of commands from the team's own process, in step or not.
  std::uint64_t heard() const {
    return counts_.in_step + counts_.late + counts_.duplicate + counts_.ahead;
  }

  const CommandCounts& counts() const { return counts_; }

 private:
  std::uint32_t expected_ = 0;
  std::optional<std::uint32_t> answered_;
  CommandCounts counts_;
};

}  // namespace mirocup::dds
