// SPDX-License-Identifier: MIT
//
// The shapes that a team draws in one tick, in a fixed form that fits into the mailbox.
//
// The team's process writes the page. The server copies it once and trusts nothing in the copy.
#pragma once

#include "core/match/thought.hpp"

#include <array>
#include <cstdint>
#include <optional>

namespace mirocup::plugins {

struct ThoughtsPage {
  // The numbers and the text of a shape follow the numbers and the text of the shape before.
  struct Shape {
    match::ThoughtKind kind;
    std::uint32_t colour;
    std::uint32_t numbers;                  // count of the shape's numbers
    std::uint32_t text;                     // bytes of the shape's text
    char layer[match::max_layer_name + 1];  // ends with a zero
  };

  std::uint32_t shapes = 0;
  std::uint32_t numbers = 0;
  std::uint32_t text = 0;
  std::uint32_t left_out = 0;  // number of dropped shapes of this tick
  std::array<Shape, match::max_thoughts> shape;
  std::array<double, match::max_thought_numbers> number;
  std::array<char, match::max_thought_text> texts;

  // Empties the page before a tick.
  void clear() { shapes = numbers = text = left_out = 0; }
};

// Copies the used part of a page that its writer may be changing.
void copy_thoughts(const ThoughtsPage& from, ThoughtsPage& to);

// Visits the shapes of a copy, and ends early if the page contradicts itself.
class ThoughtReader {
 public:
  explicit ThoughtReader(const ThoughtsPage& page) : page_(page) {}
  std::optional<match::Thought> next();

 private:
  const ThoughtsPage& page_;
  std::size_t shape_ = 0;
  std::size_t number_ = 0;
  std::size_t text_ = 0;
};

}  // namespace mirocup::plugins
