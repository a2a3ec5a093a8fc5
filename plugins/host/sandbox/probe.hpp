// SPDX-License-Identifier: MIT
//
// Finds out how well this machine can isolate a team's process.
#pragma once

#include "core/base/error.hpp"
#include "plugins/host/sandbox/isolation.hpp"

#include <string>

namespace mirocup::plugins {

// Returns the strongest tier that this machine allows, T1 or T2. To try T2, forks a process that
// sets up its namespaces and ends. If not even T1 is possible, the error, Errc::unavailable, names
// the missing feature.
Result<Isolation> strongest_isolation();

// Returns the step of T2 that this machine refuses, with its error and a remedy, for people; "" if
// the machine allows T2. Forks like strongest_isolation().
std::string why_no_t2();

}  // namespace mirocup::plugins
