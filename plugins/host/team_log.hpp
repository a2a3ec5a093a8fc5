// SPDX-License-Identifier: MIT
//
// The output of a team in a leg, bounded and escaped.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace mirocup::plugins {

// Keeps the beginning and the end of the output, and counts the bytes between them.
class TeamLog {
 public:
  static constexpr std::size_t max_beginning = 40u << 10;  // bytes, escaped
  static constexpr std::size_t max_end = 20u << 10;

  void append(std::string_view bytes);

  // Returns the log, escaped, at most 64 KiB.
  std::string text() const;

 private:
  std::string beginning_;  // raw
  std::string end_;        // raw, at most twice max_end
  std::size_t left_out_ = 0;
};

}  // namespace mirocup::plugins
