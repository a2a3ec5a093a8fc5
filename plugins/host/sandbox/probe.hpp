// SPDX-License-Identifier: MIT
//
// Finds out how well this machine can isolate a team's process.
#pragma once

#include "core/base/error.hpp"
#include "plugins/host/sandbox/isolation.hpp"

#include <string>

namespace mirocup::plugins {

// Returns the strongest tier that this machine allows, T1 or T2. T2 is tried by forking a process
// that sets up its namespaces and ends. An error, Errc::unavailable, says what is missing below T1.
Result<Isolation> strongest_isolation();

// Returns the step of T2 that this machine refuses, with its error and a cure, for people; "" if it
// allows T2. Forks like strongest_isolation().
std::string why_no_t2();

}  // namespace mirocup::plugins
