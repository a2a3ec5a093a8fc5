// SPDX-License-Identifier: MIT
//
// Reads a shared library without loading it: whether it is a complete library for this machine, its
// exports and the libraries that it needs.
//
// The bytes come from a stranger: every offset is checked before it is followed, no code runs, and
// the size of the file bounds time and memory to a tenth of a second and some hundred KiB, whatever
// the tables of the file claim. The project does not use libelf, so that all of these checks are in
// this reader. A library that passes the checks can still fail to load, which only the sandbox
// finds out.
#pragma once

#include <tl/expected.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace mirocup::plugins {

struct SharedLibrary {
  std::vector<std::string> needed;  // names of the libraries that this library needs (DT_NEEDED)
  std::string search_path;          // DT_RUNPATH or DT_RPATH; "" if the library has neither
  bool exports_entry = false;       // true: the library defines a function mirocup_entry
};

// Reads the whole file in `bytes`. The error is a sentence with advice for the library's author.
tl::expected<SharedLibrary, std::string> read_shared_library(std::string_view bytes);

}  // namespace mirocup::plugins
