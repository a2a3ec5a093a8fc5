// SPDX-License-Identifier: MIT
//
// The time of day and the time since the machine was started, as a team's process sees them.
//
// A leg must be repeatable, so it must not depend on the time of day. In every leg the time of day
// begins with the same reading, so that a team that seeds its random numbers with time() repeats a
// leg exactly. `mirocup check` plays a leg twice with different readings to find such a team.
// Differences between two readings and processor time are true, except in legs in which `mirocup
// check` looks for a team whose answers depend on them.
//
// This prevents honest mistakes. A team that asks the processor or the kernel directly sees other
// clocks, and harms only itself.
#pragma once

#include <cstdint>

namespace mirocup::plugins {

// The readings of the clocks, s. They should never be ahead of the machine's clocks, or a wait
// until a time would last too long.
struct ClockReadings {
  std::int64_t time_of_day = 946'684'800;  // when the process starts: 1 January 2000, UTC
  std::int64_t uptime_behind = 0;          // how far the time since the machine's start lags
  // Time that is added on every clock between two calls of the team, ns. If it is the control
  // period, a leg that is over in a moment takes as long on its clocks as a leg in real time.
  std::int64_t between_calls = 0;
  // If not 0: each reading advances every clock by this much, ns, and no other time passes. Then
  // also a team whose answers depend on a clock repeats its answers.
  std::int64_t each_reading = 0;
};

// From here on clock_gettime(), time(), gettimeofday(), timespec_get(), clock() and functions on
// top of them (std::chrono, for example) start from these readings.
void start_clocks(const ClockReadings& readings);

// To be called before each call of the team: lets the time between two calls pass.
void pass_time_between_calls();

}  // namespace mirocup::plugins
