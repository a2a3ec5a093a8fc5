// SPDX-License-Identifier: MIT
//
// The text of mirocup/team.py, as part of the program.
#pragma once

#include <string_view>

namespace mirocup::python {

// Returns the text of the file `name`; "" if the program lacks the file.
std::string_view team_source(std::string_view name);

}  // namespace mirocup::python
