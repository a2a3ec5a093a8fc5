// SPDX-License-Identifier: MIT
//
// Advice to an author whose file cannot be a team, from the bytes of the file alone.
#pragma once

#include <string>
#include <string_view>

namespace mirocup::plugins {

// The files of a team.
inline constexpr const char* what_is_taken =
    "hand in a library (.so), a source (.cpp, .c), a file of Python (.py), or a project as "
    ".tar.gz, .tar or .zip";

// Returns advice about a file of another known kind than a shared library, such as an archive or a
// source; "" if its kind is not known.
std::string advice_on_file(std::string_view bytes);

// Returns why these bytes are neither a source nor an archive of a project that is taken, and what
// to do; "" if they may be.
std::string objection_to_source(std::string_view bytes);

// Returns what a text is that did not compile, if it is none of C or C++; "" if it may be one.
std::string advice_on_no_source(std::string_view bytes);

// Returns advice about a library that exports no mirocup_entry(). It may export the function under
// a C++ name.
std::string advice_on_missing_entry(std::string_view bytes);

}  // namespace mirocup::plugins
