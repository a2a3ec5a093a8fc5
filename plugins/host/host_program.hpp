// SPDX-License-Identifier: MIT
//
// The program in whose process a team plays.
#pragma once

#include "core/base/error.hpp"
#include "plugins/host/sealed_entry.hpp"

#include <string>

namespace mirocup::plugins {

enum class Care { none, watched };  // watched: the program looks for mistakes in the use of memory

// Returns the path of the program for the entry. Python itself watches a team in Python. Errors:
// Errc::unavailable if the part that plays Python is not built or installed.
Result<std::string> host_program(const SealedEntry& entry, Care care = Care::none);

// The same for the module by which --trusted plays Python.
Result<std::string> python_module();

}  // namespace mirocup::plugins
