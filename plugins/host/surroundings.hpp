// SPDX-License-Identifier: MIT
//
// The surroundings of a team's process, which must not change its answers. They are the same in
// every leg; `mirocup check` plays a leg again in other surroundings, so that it finds a team whose
// answers depend on them.
#pragma once

#include "plugins/host/team_clocks.hpp"

#include <cstdint>

namespace mirocup::plugins {

struct Surroundings {
  ClockReadings clocks;
  // True: the stack, the heap and the libraries lie at the same addresses in every process.
  bool fixed_addresses = true;
  // The byte that fills memory which the team has not written, on its heap and its stack; only
  // mirocup-careful-host fills memory.
  std::uint8_t memory_fill = 0;
  // Added to the numbers of the process, the thread and the processor that the team sees, and to
  // the number of processors; only in mirocup-careful-host.
  std::int32_t number_offset = 0;
};

}  // namespace mirocup::plugins
