// SPDX-License-Identifier: MIT
//
// Advice to an author who hands in a file that cannot be a team, by its bytes alone.
#pragma once

#include <string>
#include <string_view>

namespace mirocup::plugins {

// Returns advice about a file that is no shared library but something else that is known, such as
// an archive or a source; "" if it is not known.
std::string advice_on_file(std::string_view bytes);

// Returns advice about a library that exports no mirocup_entry(); it may be there under a C++ name.
std::string advice_on_missing_entry(std::string_view bytes);

}  // namespace mirocup::plugins
