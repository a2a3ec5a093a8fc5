// SPDX-License-Identifier: MIT
//
// In the team's process: what is done around each call of the team's code.
//
// mirocup-plugin-host, with which matches are played, does nothing (no_care.cpp).
// mirocup-careful-host, with which `mirocup check` looks for mistakes, watches the team's memory
// and what it asks the system for (careful/).
#pragma once

#include "mirocup/strategy.h"
#include "plugins/host/surroundings.hpp"

#include <cstddef>

namespace mirocup::plugins {

// Before any code of the team runs.
void begin_care(const Surroundings& surroundings);

// Before and after each call of the team's code. after_call() returns a sentence about the first
// mistake in its use of memory, which stays valid, or null.
void before_call();
const char* after_call();

// Returns the observation, or a copy of it, which the team may read during the call.
const mirocup_observation& lend(const mirocup_observation& observation);

// Writes what the team asked the system for until now, one request a line ("file map.txt"), into
// `text`, which ends with a zero.
void write_requests(char* text, std::size_t size);

}  // namespace mirocup::plugins
