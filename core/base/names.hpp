// SPDX-License-Identifier: MIT
//
// The text of an enumerator and back. Every enum that is written to a file or read from a command
// line says its names once, as a specialisation of enum_names, in the order of its values from 0.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace mirocup {

// Specialise for an enum E: an std::array of std::string_view, one name per enumerator.
template <class E>
inline constexpr std::array<std::string_view, 0> enum_names{};

template <class E>
constexpr std::string_view to_string(E value) {
  return enum_names<E>[static_cast<std::size_t>(value)];
}

// The enumerator of that name, or nothing.
template <class E>
constexpr std::optional<E> from_string(std::string_view name) {
  const auto& names = enum_names<E>;
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) return std::nullopt;
  return static_cast<E>(found - names.begin());
}

// All names, for an error message: "small, middle, large".
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
