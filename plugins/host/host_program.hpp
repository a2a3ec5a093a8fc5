// SPDX-License-Identifier: MIT
//
// The program in whose process a team plays.
#pragma once

#include "core/base/error.hpp"
#include "plugins/host/sealed_entry.hpp"

#include <string>

namespace mirocup::plugins {

enum class Care { none, watched };  // watched: mistakes in the use of memory are looked for

// Returns the path of the program for the entry. A team in Python is watched by Python itself.
// Errors: Errc::unavailable where the part that plays Python is not built or installed.
Result<std::string> host_program(const SealedEntry& entry, Care care = Care::none);

// The same for the module by which --trusted plays Python.
Result<std::string> python_module();

}  // namespace mirocup::plugins
