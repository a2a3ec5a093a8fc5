// SPDX-License-Identifier: MIT
//
// The time of day and the time since the machine was started, as a team's process sees them.
//
// Time of day has no place in a leg that can be asked for again. In every leg it begins with the
// same reading, so that a team that seeds its random numbers with time() plays a leg again as it
// was. `mirocup check` plays a leg twice with different readings, so that it finds such a team.
// Differences between two readings are true, and so is processor time, but in legs in which
// `mirocup check` looks for a team whose answers depend on them.
//
// This is for honest mistakes. A team that asks the processor or the kernel by itself sees other
// clocks, and what it can do with them is hurt itself.
#pragma once

#include <cstdint>

namespace mirocup::plugins {

// What the clocks show, s. They should never show more than the machine's, so that no wait for a
// time lasts longer than it should.
struct ClockReadings {
  std::int64_t time_of_day = 946'684'800;  // when the process starts: 1 January 2000, UTC
  std::int64_t uptime_behind = 0;          // by so much the time since the start of the machine
  // What passes between two calls of the team besides the time that does, on every clock, ns. With
  // the control period a leg that is over in a moment takes as long as a leg in real time.
  std::int64_t between_calls = 0;
  // Not 0: no time passes but this much with each reading, on every clock, ns. A team that answers
  // by a clock then answers in the same way again.
  std::int64_t each_reading = 0;
};

// From here on clock_gettime(), time(), gettimeofday(), timespec_get(), clock() and what is built
// on them
// (std::chrono, for example) show these readings and go on from there.
void start_clocks(const ClockReadings& readings);

// Before each call of the team: lets the time between two calls pass.
void pass_time_between_calls();

}  // namespace mirocup::plugins
