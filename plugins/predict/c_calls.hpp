// SPDX-License-Identifier: MIT
//
// How the functions of skills.h call C++, for c_skills.cpp and c_predict.cpp. Most of them are made
// by declarations.py: Cpp::of() converts their arguments, and C::of() their results. Here is what
// is the same in both languages; each source adds its own structures.
#pragma once

#ifdef MIROCUP_EXPORTED_SKILLS
#pragma GCC visibility push(default)
#endif
#include "mirocup/skills.h"
#ifdef MIROCUP_EXPORTED_SKILLS
#pragma GCC visibility pop
#endif

namespace mirocup::strategy {}
namespace strategy = mirocup::strategy;

namespace {

// C gives objects by their addresses.
struct SameInCpp {
  static auto of(auto value) { return value; }
  static auto& of(auto* object) { return *object; }
};
struct SameInC {
  static auto of(auto value) { return value; }
};

}  // namespace
