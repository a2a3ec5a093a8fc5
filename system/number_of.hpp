// SPDX-License-Identifier: MIT
#pragma once

#include <charconv>
#include <cmath>
#include <concepts>
#include <cstdlib>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

namespace mirocup::system {

// Returns the number that the whole text spells, as std::from_chars() reads it. `format` is absent,
// or the base of an integer.
template <class Number, class... Format>
std::optional<Number> whole_number(std::string_view text, Format... format) {
  Number number{};
  const auto read = std::from_chars(text.data(), text.data() + text.size(), number, format...);
  const bool is_number = read.ec == std::errc() && read.ptr == text.data() + text.size() &&
                         std::isfinite(static_cast<double>(number));
  return is_number ? std::optional(number) : std::nullopt;
}

// Returns the number that the whole text spells. Returns nothing for any other text, also with a
// '+' or spaces, for NaN and infinity, and for a number that is out of the range of its type.
template <class Number>
std::optional<Number> number_of(std::string_view text) {
  return whole_number<Number>(text);
}

#ifdef __wasi__
// The C++ library of the module for browsers has no std::from_chars() of a double.
template <>
inline std::optional<double> number_of<double>(std::string_view text) {
  const std::string copy(text);
  const bool has_other_signs = copy.find_first_not_of("0123456789+-.eE") != std::string::npos;
  if (copy.empty() || copy.front() == '+' || has_other_signs) return std::nullopt;
  char* end = nullptr;
  const double number = std::strtod(copy.c_str(), &end);
  return *end == '\0' && std::isfinite(number) ? std::optional(number) : std::nullopt;
}
#endif

// Returns the integer that the whole text spells in hexadecimal digits.
template <std::unsigned_integral Number>
std::optional<Number> hexadecimal_of(std::string_view text) {
  return whole_number<Number>(text, 16);
}

}  // namespace mirocup::system
