// SPDX-License-Identifier: MIT
//
// Compiles a stranger's source into a library in a sandbox: separate namespaces, no network,
// read-only copies of the system's compiler and headers and of the strategy's headers, and a folder
// in memory. The command line is fixed. Nothing that was compiled runs.
#pragma once

#include "core/base/error.hpp"

#include <string>

namespace mirocup::plugins {

// The kind of a source: a file of C17 or of C++20, or an archive with a project
// (project/unpack.hpp).
enum class SourceLanguage { c, cpp, project };

// The program and the files of mirocup that the compiler gets.
struct CompilerKit {
  std::string headers;           // folder of strategy.h
  std::string predict;           // library of predict.hpp; left out if the file is missing
  std::string project_compiler;  // the program mirocup-project-compiler
};

struct CompileLimits {
  double seconds = 60.0;      // of processor time of all processes together
  double wall = 600.0;        // s of wall time; a longer compilation is the host's fault
  unsigned cpu_seconds = 40;  // of each process of the compiler
  std::size_t memory = std::size_t{3} << 29;    // bytes of addresses of each process
  std::size_t library = std::size_t{32} << 20;  // bytes
  std::size_t output = std::size_t{64} << 10;   // bytes of the compiler's messages that are kept
};

struct Compiled {
  std::string library;  // its bytes; "" if it was not compiled
  std::string why_not;  // a sentence; "": it was compiled
  std::string output;   // the compiler's messages, cut
};

// A mistake in the source is a value (`why_not`). Errors: Errc::unavailable if there are no
// namespaces or no compiler; Errc::host.
Result<Compiled> compile_in_sandbox(const std::string& source, SourceLanguage language,
                                    const CompilerKit& kit, const CompileLimits& limits = {});

}  // namespace mirocup::plugins
