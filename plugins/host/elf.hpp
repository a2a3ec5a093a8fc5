// SPDX-License-Identifier: MIT
//
// Reads a shared library without loading it: whether it is a complete library for this machine, its
// exports and the libraries that it needs.
//
// The bytes come from a stranger: every offset is checked before it is followed, no code runs, and
// the size of the file bounds time and memory: a tenth of a second and some hundred KiB, whatever
// its tables claim. This is our own reader instead of libelf, so that all of these checks are here.
// A library that passes can still fail to load; the sandbox finds that out.
#pragma once

#include <tl/expected.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace mirocup::plugins {

struct SharedLibrary {
  std::vector<std::string> needed;  // names of the libraries that it needs (DT_NEEDED)
  std::string search_path;          // DT_RUNPATH or DT_RPATH; "" if it has none
  bool exports_entry = false;       // true: it defines a function mirocup_entry
};

// Reads the whole file in `bytes`. An error is a sentence with advice for the author.
tl::expected<SharedLibrary, std::string> read_shared_library(std::string_view bytes);

}  // namespace mirocup::plugins
