// SPDX-License-Identifier: MIT
//
// In the team's process: the work around each call of the team's code.
//
// mirocup-plugin-host, which plays matches, has no such work (no_care.cpp). mirocup-careful-host,
// with which `mirocup check` looks for mistakes, watches the team's memory and its requests to the
// system (careful/).
#pragma once

#include "mirocup/strategy.h"
#include "plugins/host/surroundings.hpp"

#include <cstddef>

namespace mirocup::plugins {

// To be called before any code of the team runs.
void begin_care(const Surroundings& surroundings);

// A mistake in the use of memory.
struct Mistake {
  const char* text = nullptr;    // a sentence, valid until the process ends; null: no mistake
  const char* cause = "memory";  // Fault::cause
};

// To be called before and after each call of the team's code. after_call() returns the team's first
// mistake.
void before_call();
Mistake after_call();

// Returns the observation or a copy, for the team to read during the call.
const mirocup_observation& lend(const mirocup_observation& observation);

// Returns the place for the command of the next call of decide(), all zeros.
mirocup_command& lend_command();

// Writes the requests that the team has made to the system so far into `text`, one in a line ("file
// map.txt"). A zero ends the text.
void write_requests(char* text, std::size_t size);

}  // namespace mirocup::plugins
