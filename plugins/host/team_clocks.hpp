// SPDX-License-Identifier: MIT
//
// The clocks of a team's process: the time of day and the time since the machine was started.
//
// A leg must be repeatable, so it must not depend on the time of day. In every leg the time of day
// begins with the same reading, so that a team that seeds its random numbers with time() repeats a
// leg exactly. `mirocup check` plays a leg twice with different readings to find such a team. The
// time that passes between two readings and the processor time are the real ones, except when
// `mirocup check` looks for a team whose answers depend on clocks.
//
// These clocks prevent honest mistakes. A team that asks the processor or the kernel directly sees
// other clocks, and harms only itself.
#pragma once

#include <cstdint>

namespace mirocup::plugins {

// The first readings of the clocks, s. A reading should not be ahead of the machine's clock:
// otherwise a team's wait until a given time would last too long.
struct ClockReadings {
  std::int64_t time_of_day = 946'684'800;  // when the process starts: 1 January 2000, UTC
  std::int64_t uptime_behind = 0;  // is subtracted from the time since the machine was started
  // Time added to every clock between two calls of the team, ns. If this is the control period,
  // a fast leg takes as long on the team's clocks as a leg in real time.
  std::int64_t between_calls = 0;
  // If not 0, each reading advances every clock by this time, ns, and no other time passes. Then
  // even a team whose answers depend on a clock repeats its answers.
  std::int64_t each_reading = 0;
};

// From now on clock_gettime(), time(), gettimeofday(), timespec_get(), clock() and functions on top
// of them (std::chrono, for example) start from these readings.
void start_clocks(const ClockReadings& readings);

// To be called before each call of the team: lets the time between two calls pass.
void pass_time_between_calls();

}  // namespace mirocup::plugins
