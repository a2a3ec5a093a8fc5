// SPDX-License-Identifier: MIT
//
// What the server counts of a team that plays over the network; the record has these numbers.
#pragma once

#include <cstdint>
#include <optional>

namespace mirocup::record {

// One absence of the team: the server notices it, the record lists it.
struct Absence {
  std::uint32_t tick = 0;             // the first tick without an answer
  std::uint32_t noticed = 0;          // the tick in which the server noticed the absence
  std::optional<std::uint32_t> back;  // the next tick answered in step; empty: no such tick
  // True: the team's process had gone; false: the process was silent.
  bool has_left = false;
};

// Commands by their fate. In a tick without a command in step, the newest late one could be driven.
struct CommandCounts {
  std::uint64_t in_step = 0;      // answered the present tick; at most one command for each tick
  std::uint64_t late = 0;         // answered a tick that was over
  std::uint64_t late_driven = 0;  // late commands that were driven
  std::uint64_t duplicate = 0;    // further answers to the last tick that was answered in step
  std::uint64_t ahead = 0;        // answered a tick that had not begun
  std::uint64_t foreign = 0;      // from a process without the team's seat
};

// Datagrams of a team that plays by FIRASim's protocol, by their fate. Only datagrams that reached
// the server are counted.
struct DatagramCounts {
  std::uint64_t received = 0;        // commands of the team's own sender
  std::uint64_t placements = 0;      // placements by the team
  std::uint64_t stale = 0;           // for another vision or, in lock-step, after the answer
  std::uint64_t malformed = 0;       // datagrams of any sender that are not a message
  std::uint64_t replacements = 0;    // refused replacements, because a team may not move bodies
  std::uint64_t not_finite = 0;      // commands with NaN or an infinity
  std::uint64_t unknown_robots = 0;  // commands to a robot that does not exist

  bool operator==(const DatagramCounts&) const = default;
};

}  // namespace mirocup::record
