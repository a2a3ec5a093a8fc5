// SPDX-License-Identifier: MIT
//
// The fixed options with which a league compiles: plain 64-bit code that each host of the league
// can run, linked with a static C++ library, so that it does not depend on a host's C++ library,
// and without fused multiply-adds, so that arithmetic rounds alike on every host.
#pragma once

namespace mirocup::plugins {

inline constexpr const char* c_compiler = "/usr/bin/gcc";
inline constexpr const char* cpp_compiler = "/usr/bin/g++";

// In the sandbox, /mirocup/include has the strategy's headers, /mirocup/lib the library of
// predict.hpp.
#define MIROCUP_COMPILER_OPTIONS                                                                \
  "-O2", "-DNDEBUG", "-ffp-contract=off", "-fPIC", "-fvisibility=hidden", "-I/mirocup/include", \
      "-fno-diagnostics-color", "-fmax-errors=20"
// A function that C does not know would be missed only when the library is loaded.
#define MIROCUP_C_OPTIONS \
  "-std=c17", "-Werror=implicit-function-declaration", MIROCUP_COMPILER_OPTIONS
#define MIROCUP_CPP_OPTIONS \
  "-std=c++20", "-ftemplate-depth=900", "-Woverloaded-virtual", MIROCUP_COMPILER_OPTIONS
#define MIROCUP_LINK_OPTIONS "-shared", "-static-libgcc", "-L/mirocup/lib"

// The exit code of mirocup-project-compiler if it refuses the archive; its last line says why.
inline constexpr int refused_archive = 3;

}  // namespace mirocup::plugins
