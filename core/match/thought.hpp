// SPDX-License-Identifier: MIT
//
// Shapes and texts that a team draws into the replay for its own eyes. Thoughts have no effect on
// the leg: they are not part of its hash, its record or its verification.
#pragma once

#include "core/base/names.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace mirocup::match {

enum class ThoughtKind { line, circle, polygon, text };

// One shape of one tick, in the team's own frame. `layer`, `numbers` and `text` are not copies:
// they point into memory of the reader or message from which the shape came.
struct Thought {
  ThoughtKind kind = ThoughtKind::line;
  std::uint32_t colour = 0;  // 0xRRGGBBAA
  std::string_view layer;    // at most max_layer_name bytes, of any value
  // m. Line: x1, y1, x2, y2. Circle: x, y, radius. Polygon: x, y of each corner. Text: x, y.
  std::span<const double> numbers;
  std::string_view text;  // any bytes
};

// The limits of one tick and of one leg; thoughts beyond them are counted and dropped.
inline constexpr std::size_t max_layer_name = 31;      // bytes
inline constexpr std::size_t max_thoughts = 200;       // in a tick
inline constexpr std::size_t max_thought_text = 4096;  // bytes in a tick
inline constexpr std::size_t max_polygon_corners = 32;
inline constexpr std::size_t max_thought_bytes = 32u << 20;  // in a leg, in their written form
inline constexpr std::size_t max_thought_numbers = 10 * max_thoughts;  // in a tick

// Says whether a shape of that kind can have that many numbers.
constexpr bool is_complete(ThoughtKind kind, std::size_t numbers) {
  switch (kind) {
    case ThoughtKind::line:
      return numbers == 4;
    case ThoughtKind::circle:
      return numbers == 3;
    case ThoughtKind::polygon:
      return numbers % 2 == 0 && numbers >= 6 && numbers <= 2 * max_polygon_corners;
    case ThoughtKind::text:
      return numbers == 2;
  }
  return false;
}

inline bool is_finite(std::span<const double> numbers) {
  return std::all_of(numbers.begin(), numbers.end(), [](double n) { return std::isfinite(n); });
}

}  // namespace mirocup::match

namespace mirocup {

template <>
inline constexpr std::array<std::string_view, 4> enum_names<match::ThoughtKind>{"line", "circle",
                                                                                "polygon", "text"};

}  // namespace mirocup
