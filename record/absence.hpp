// SPDX-License-Identifier: MIT
//
// One absence of a team that plays over the network: the server notices it, the record lists it.
#pragma once

#include <cstdint>
#include <optional>

namespace mirocup::record {

struct Absence {
  std::uint32_t tick = 0;             // the first tick without an answer
  std::uint32_t noticed = 0;          // the tick in which the server noticed the absence
  std::optional<std::uint32_t> back;  // the next tick answered in step; empty: no such tick
  // True: the team's process had gone; false: the process was silent.
  bool has_left = false;
};

}  // namespace mirocup::record
