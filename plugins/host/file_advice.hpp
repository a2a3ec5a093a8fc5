// SPDX-License-Identifier: MIT
//
// Advice to an author whose file cannot be a team, from the bytes of the file alone.
#pragma once

#include <string>
#include <string_view>

namespace mirocup::plugins {

// The kinds of files that can be a team, in words.
inline constexpr const char* what_is_taken =
    "hand in a library (.so), a source (.cpp, .c), a file of Python (.py), or a project as "
    ".tar.gz, .tar or .zip";

// A finding about a file, and what to do.
struct FileAdvice {
  std::string what;
  std::string cure;
};

// Returns the parts of a text of this header or of read_shared_library(): the finding stands before
// its last ": ".
FileAdvice parts_of(const std::string& text);

// Returns advice about a file of a known kind that is not a shared library, such as an archive or a
// source; "" if the kind is not known.
std::string advice_on_file(std::string_view bytes);

// Returns why these bytes are neither a source nor an accepted archive of a project, with a remedy;
// "" if they may be either.
std::string objection_to_source(std::string_view bytes);

// Returns the kind of a text that did not compile and is neither C nor C++; "" if it may be C or
// C++.
std::string advice_on_no_source(std::string_view bytes);

// Returns compile_advice.txt: advice by the words of compilers.
std::string_view compile_advice(std::string_view file);

// Returns advice about a library that exports no mirocup_entry(). Such a library may export the
// function under a C++ name.
std::string advice_on_missing_entry(std::string_view bytes);

// Returns the sanitizer that a library was built with, as -fsanitize names it, or "".
std::string sanitizer_of(std::string_view library);

// True if the dynamic loader finds a library of that name in the sandbox.
bool is_in_sandbox(const std::string& name);

}  // namespace mirocup::plugins
