// SPDX-License-Identifier: MIT
//
// The tiers of isolation of a team's process. plugins/host/README.md describes each tier.
#pragma once

#include "core/base/names.hpp"

namespace mirocup::plugins {

enum class Isolation {
  none,  // the team runs in the server's own process
  T1,    // limits, system-call filter, Landlock
  T2,    // like T1, also in separate namespaces with an empty root
};

}  // namespace mirocup::plugins

namespace mirocup {

template <>
inline constexpr std::array<std::string_view, 3> enum_names<plugins::Isolation>{"none", "T1", "T2"};

}  // namespace mirocup
