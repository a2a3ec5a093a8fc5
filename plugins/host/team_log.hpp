// SPDX-License-Identifier: MIT
//
// What a team printed in a leg: capped, and made harmless to show.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace mirocup::plugins {

// The text with every byte written out as \xNN that a terminal, a page or a person could mistake
// for something else: control characters but line ends and tabs, what is not UTF-8, and the
// characters that turn the direction of writing.
std::string escape_unprintable(std::string_view text);

// Keeps the beginning and the end; what is between is counted.
class TeamLog {
 public:
  static constexpr std::size_t max_beginning = 40u << 10;  // bytes, escaped
  static constexpr std::size_t max_end = 20u << 10;

  void append(std::string_view bytes);

  // At most 64 KiB.
  std::string text() const;

 private:
  std::string beginning_;  // raw
  std::string end_;        // raw, at most twice max_end
  std::size_t left_out_ = 0;
};

}  // namespace mirocup::plugins
