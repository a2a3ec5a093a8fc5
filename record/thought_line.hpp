// SPDX-License-Identifier: MIT
//
// One shape as a line of mirocup/thoughts/1 (schema.md): JSON with a line break behind it.
//
// A team may draw two hundred shapes in a tick, and a tick of a leg takes some 20 us. So a new line
// reuses the part that it shares with the previous line, instead of formatting that part again.
#pragma once

#include "core/match/thought.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace mirocup::record {

class ThoughtLine {
 public:
  // Returns the line of a shape, which stays valid until the next call. Numbers are written to 0.1
  // mm, and numbers beyond 1 km as 1 km. Bytes that are not text are escaped.
  std::string_view write(std::uint32_t tick, const match::Thought& thought);

 private:
  void write_head(std::uint32_t tick, const match::Thought& thought);
  void write_tail(const match::Thought& thought);

  std::string line_;      // the head and the rest of the line
  std::size_t head_ = 0;  // size of the head, which has tick, layer, colour and kind; 0: none
  std::size_t tick_ = 0;  // size of the part of the head that has the tick
  std::uint32_t head_tick_ = 0;  // the tick in the head
  match::ThoughtKind kind_ = match::ThoughtKind::line;
  std::uint32_t colour_ = 0;
  std::string layer_;
};

}  // namespace mirocup::record
