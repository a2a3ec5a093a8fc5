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
  std::string predict;           // library of predict.hpp; not used if the file is missing
  std::string project_compiler;  // the program mirocup-project-compiler
};

struct CompileLimits {
  double seconds = 60.0;      // processor time of all processes together, s
  double wall = 600.0;        // wall time, s; a longer compilation is the host's fault
  unsigned cpu_seconds = 40;  // processor time of each process of the compiler, s
  std::size_t memory = std::size_t{3} << 29;    // address space of each process, bytes
  std::size_t library = std::size_t{32} << 20;  // size of the library, bytes
  std::size_t output = std::size_t{64} << 10;   // kept bytes of the compiler's messages
};

struct Compiled {
  std::string library;  // the bytes of the library; "" if it was not compiled
  std::string why_not;  // why nothing was compiled, a sentence; "": it was compiled
  std::string output;   // the compiler's messages, cut at the limit
};

// Compiles a source. A mistake in the source is not an error: then the result has a reason in
// `why_not`. Errors: Errc::unavailable if this machine has no namespaces or no compiler;
// Errc::host for every other failure.
Result<Compiled> compile_in_sandbox(const std::string& source, SourceLanguage language,
                                    const CompilerKit& kit, const CompileLimits& limits = {});

}  // namespace mirocup::plugins
