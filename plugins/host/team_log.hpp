// SPDX-License-Identifier: MIT
//
// The output of a team in a leg, bounded and escaped. A line can be marked with the tick in which
// it began.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace mirocup::plugins {

enum class Ticks { left_out, shown };

// Keeps the beginning and the end of the output, and counts the bytes between them.
class TeamLog {
 public:
  static constexpr std::size_t max_beginning = 40u << 10;  // bytes, escaped
  static constexpr std::size_t max_end = 20u << 10;
  // The end of the line that replaces the bytes between beginning and end.
  static constexpr std::string_view left_out_here = " bytes are left out here]\n";

  void append(std::string_view bytes);
  void append(std::string_view bytes, std::uint32_t tick);

  // Returns the log, escaped, at most 64 KiB; with "tick 606: " before each line that is marked, at
  // most twice as long.
  std::string text(Ticks ticks = Ticks::left_out) const;

 private:
  void add(std::string_view raw);

  std::string beginning_;  // raw
  std::string end_;        // raw bytes, at most twice max_end
  std::size_t left_out_ = 0;
  bool is_in_a_line_ = false;
};

}  // namespace mirocup::plugins
