// SPDX-License-Identifier: MIT
//
// The files of page/, which the build compiles into the program.
#pragma once

#include <string_view>

namespace mirocup::web {

// Returns the text of page/NAME; empty if there is no such file.
std::string_view asset(std::string_view name);

}  // namespace mirocup::web
