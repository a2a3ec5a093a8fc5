// SPDX-License-Identifier: MIT
//
// The files of page/, which the build compiles into the program.
#pragma once

#include <string_view>

namespace mirocup::web {

// Returns the text of the file page/NAME; empty if the program lacks the file.
std::string_view asset(std::string_view name);

}  // namespace mirocup::web
