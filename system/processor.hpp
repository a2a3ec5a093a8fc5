// SPDX-License-Identifier: MIT
//
// The levels of x86-64 processors, as compilers name them in -march. A processor of a level has all
// instructions of the levels before it.
#pragma once

#include "core/base/names.hpp"

#include <array>
#include <string_view>

namespace mirocup {

namespace system {

enum class Processor { v1, v2, v3, v4 };

}  // namespace system

template <>
inline constexpr std::array<std::string_view, 4> enum_names<system::Processor>{
    "x86-64", "x86-64-v2", "x86-64-v3", "x86-64-v4"};

}  // namespace mirocup
