// SPDX-License-Identifier: MIT
//
// Compiles a stranger's source into a library, in a sandbox: in namespaces of its own, without a
// network, with the system's compiler, its headers and those of a strategy, all read-only, and a
// folder in memory. The command line is fixed. Nothing that was compiled runs.
#pragma once

#include "core/base/error.hpp"

#include <string>

namespace mirocup::plugins {

// What a source is: a file of C17 or of C++20, or an archive with a project (project/unpack.hpp).
enum class SourceLanguage { c, cpp, project };

// The project's own program and files that the compiler is given.
struct CompilerKit {
  std::string headers;           // folder of strategy.h
  std::string predict;           // library of predict.hpp; is left out if there is none
  std::string project_compiler;  // the program mirocup-project-compiler
};

struct CompileLimits {
  double seconds = 60.0;  // of processor time of all processes together
  double wall = 600.0;    // s on the clock; a compiler that waits for so long is the host's fault
  unsigned cpu_seconds = 40;                    // of each process of the compiler
  std::size_t memory = std::size_t{3} << 29;    // bytes of addresses of each process
  std::size_t library = std::size_t{32} << 20;  // bytes
  std::size_t output = std::size_t{64} << 10;   // bytes of what the compiler says that are kept
};

struct Compiled {
  std::string library;  // its bytes; "": there is none
  std::string why_not;  // a sentence; "": it was compiled
  std::string output;   // what the compiler has said, cut
};

// What is wrong with the source is a value. Errors: Errc::unavailable where there are no namespaces
// or no compiler; Errc::host.
Result<Compiled> compile_in_sandbox(const std::string& source, SourceLanguage language,
                                    const CompilerKit& kit, const CompileLimits& limits = {});

}  // namespace mirocup::plugins
