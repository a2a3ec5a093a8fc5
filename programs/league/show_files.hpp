// SPDX-License-Identifier: MIT
//
// The files of show/, which the build compiles into the program.
#pragma once

#include <string_view>

namespace mirocup::league {

// Returns the text of the file show/NAME; empty if the program lacks the file.
std::string_view show_file(std::string_view name);

}  // namespace mirocup::league
