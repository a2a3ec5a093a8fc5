// SPDX-License-Identifier: MIT
//
// Reads a shared library without loading it: is it one, is it complete, is it for this machine,
// what does it export and need?
//
// The bytes are a stranger's: every offset is checked before it is followed, and nothing of them is
// run. What passes here can still fail to load; that is found out in the sandbox.
#pragma once

#include <tl/expected.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace mirocup::plugins {

struct SharedLibrary {
  std::vector<std::string> needed;  // the libraries that it asks for by name
  std::string search_path;          // DT_RUNPATH or DT_RPATH; "" in an honest library
  bool exports_entry = false;       // mirocup_entry, as a function
};

// An error is a sentence for whoever built the file.
tl::expected<SharedLibrary, std::string> read_shared_library(std::string_view bytes);

}  // namespace mirocup::plugins
