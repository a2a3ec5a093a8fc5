// SPDX-License-Identifier: MIT
//
// Sorts the arriving commands of a team. The robots drive the first command that answers the
// present tick. The inbox keeps the newest late command, which the robots may drive if no command
// for the present tick has come.
#pragma once

#include "record/traffic.hpp"

#include <cstdint>
#include <optional>

namespace mirocup::dds {

// A late command is driven if it answers a tick that is at most this many ticks old. 6 ticks are
// 0.2 s at a control period of 33 ms. An older command only shows that the team is present.
inline constexpr std::uint32_t max_late_ticks = 6;

// The kinds of commands of the team's own process.
enum class Arrival {
  in_step,   // the answer to the present tick
  late,      // answers a tick that is over; neither this tick nor a newer one was answered before
  old,       // answers a tick that is over; this tick or a newer one was answered before
  repeated,  // a further answer to the last tick that was answered in step
  ahead,     // answers a tick that has not begun
};

class Inbox {
 public:
  // Sets the present tick. An answer to the present tick is in step.
  void expect(std::uint32_t tick) {
    expected_ = tick;
    is_over_ = false;
  }
  // The time of the present tick is over: until the next one begins, an answer to it is late.
  void end_tick() { is_over_ = true; }

  void count_foreign() { ++counts_.foreign; }
  void count_late_driven() { ++counts_.late_driven; }

  // Counts a command of the team's own process.
  Arrival sort(std::uint32_t tick) {
    if (tick == answered_) {
      ++counts_.duplicate;
      return Arrival::repeated;
    }
    if (tick > expected_) {
      ++counts_.ahead;
      return Arrival::ahead;
    }
    const bool is_newer = !newest_ || tick > *newest_;
    if (is_newer) newest_ = tick;
    if (tick < expected_ || is_over_) {
      ++counts_.late;
      return is_newer ? Arrival::late : Arrival::old;
    }
    answered_ = tick;
    ++counts_.in_step;
    return Arrival::in_step;
  }

  // True if the robots may still drive a command for `tick` in the present tick.
  bool may_be_driven(std::uint32_t tick) const {
    return tick <= expected_ && expected_ - tick <= max_late_ticks;
  }

  // Returns the number of commands from the team's own process, in step or not.
  std::uint64_t heard() const {
    return counts_.in_step + counts_.late + counts_.duplicate + counts_.ahead;
  }

  const record::CommandCounts& counts() const { return counts_; }

 private:
  std::uint32_t expected_ = 0;
  bool is_over_ = false;
  std::optional<std::uint32_t> answered_;
  std::optional<std::uint32_t> newest_;
  record::CommandCounts counts_;
};

}  // namespace mirocup::dds
