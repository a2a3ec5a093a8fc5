// SPDX-License-Identifier: MIT
//
// The program in whose process a team plays.
#pragma once

#include "core/base/error.hpp"
#include "plugins/host/sealed_entry.hpp"

#include <string>

namespace mirocup::plugins {

enum class Care { none, watched };  // watched: the program looks for mistakes in the use of memory

// Returns the path of the program that plays an entry. For a team in Python `care` has no effect,
// because Python itself checks memory. Errors: Errc::unavailable if the program that plays Python
// is not built or installed.
Result<std::string> host_program(const SealedEntry& entry, Care care = Care::none);

// Returns the path of the module with which --trusted plays Python. Errors are those of the
// function above.
Result<std::string> python_module();

}  // namespace mirocup::plugins
