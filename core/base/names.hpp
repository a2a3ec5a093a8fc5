// SPDX-License-Identifier: MIT
//
// Converts enumerators to text and back. Every enum that is written to a file or read from a
// command line lists its names once, in the order of its values from 0, by specialising enum_names.
#pragma once

#include "core/base/assert.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace mirocup {

// The names of an enum E, one for each enumerator. To be specialised for E.
template <class E>
inline constexpr std::array<std::string_view, 0> enum_names{};

template <class E>
constexpr std::string_view to_string(E value) {
  MIROCUP_ASSERT(static_cast<std::size_t>(value) < enum_names<E>.size());
  return enum_names<E>[static_cast<std::size_t>(value)];
}

// True if these enumerators are as many as their enum has names, and their values are 0, 1, 2, … in
// this order. For a static_assert beside an enum whose numbers are sent or written to files.
template <auto first, decltype(first)... others>
constexpr bool is_numbered_in_order() {
  int next = 0;
  return static_cast<int>(first) == next++ && ((static_cast<int>(others) == next++) && ...) &&
         enum_names<decltype(first)>.size() == 1 + sizeof...(others);
}

// Returns the enumerator with this name, or nothing.
template <class E>
constexpr std::optional<E> from_string(std::string_view name) {
  const auto& names = enum_names<E>;
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) return std::nullopt;
  return static_cast<E>(found - names.begin());
}

// Returns all names of E for an error message: "small, middle, large".
template <class E>
std::string list_of_names() {
  std::string text;
  for (const auto name : enum_names<E>) {
    if (!text.empty()) text += ", ";
    text += name;
  }
  return text;
}

}  // namespace mirocup
