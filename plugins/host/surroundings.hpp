// SPDX-License-Identifier: MIT
//
// The surroundings of a team's process, which must not change its answers. The surroundings are
// equal in every leg. `mirocup check` plays a leg again in other surroundings to find a team whose
// answers depend on the surroundings.
#pragma once

#include "plugins/host/team_clocks.hpp"

#include <cstdint>

namespace mirocup::plugins {

struct Surroundings {
  ClockReadings clocks = {};
  // True: the stack, the heap and the libraries lie at the same addresses in every process.
  bool fixed_addresses = true;
  // The byte that fills unwritten memory of the team's heap and stack. Only mirocup-careful-host
  // fills memory.
  std::uint8_t memory_fill = 0;
  // mirocup-careful-host, and no other program, adds this number to the numbers of process, thread
  // and processor, and to the count of processors, that the team sees.
  std::int32_t number_offset = 0;
};

}  // namespace mirocup::plugins
