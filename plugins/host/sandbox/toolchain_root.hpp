// SPDX-License-Identifier: MIT
//
// The file tree of the compiler in the tier `compile` (plugins/host/README.md): the system's
// compiler, headers and libraries, read-only, the headers of a strategy, and one folder in memory.
#pragma once

#include <cstddef>
#include <span>
#include <string>

namespace mirocup::plugins {

// The folder in which the compiler works. The folder has the source, and later the library.
inline constexpr const char* work_folder = "/compile";
inline constexpr const char* headers_folder = "/mirocup/include";

// A file that the tree gets.
struct TreeFile {
  std::string path;  // absolute path in the tree; its folders must come earlier in the list
  std::string bytes;
  bool is_folder = false;
};

// Makes the tree and makes it the root. Files below the work folder are in memory; all other files
// are read-only. Precondition: the process has its own mount namespace. The function allocates
// nothing, so it may be called after fork. Returns null on success, else the step that failed;
// errno says why.
const char* enter_toolchain_root(std::span<const TreeFile> files);

}  // namespace mirocup::plugins
