// SPDX-License-Identifier: MIT
//
// How well a team's process is shut in. README.md beside this folder says what each tier means.
#pragma once

#include "core/base/error.hpp"
#include "core/base/names.hpp"

namespace mirocup::plugins {

enum class Isolation {
  none,  // in the server's own process
  T1,    // limits, system-call filter, Landlock
  T2,    // T1 in namespaces of its own, with an empty root
};

// The strongest that this machine allows, found by trying it. An error, Errc::unavailable, says
// what is missing below T1.
Result<Isolation> strongest_isolation();

}  // namespace mirocup::plugins

namespace mirocup {

template <>
inline constexpr std::array<std::string_view, 3> enum_names<plugins::Isolation>{"none", "T1", "T2"};

}  // namespace mirocup
