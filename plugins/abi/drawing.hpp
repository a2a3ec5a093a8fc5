// SPDX-License-Identifier: MIT
//
// The functions of strategy.h with which a team draws, as one function of the program that runs it.
#pragma once

#include "core/match/thought.hpp"
#include "mirocup/strategy.h"

namespace mirocup::abi {

// Sets `draw_line` and its neighbours in a setup. Each passes a shape on to `draw`, with the handle
// of the host. A polygon without points, or with fewer than 3 or more than max_polygon_corners
// corners, comes without numbers. The shape refers to memory of the team.
template <void (*draw)(void* host, const match::Thought& shape)>
void give_drawing(mirocup_setup& setup) {
  using match::ThoughtKind;
  using Words = const char*;
  using Colour = std::uint32_t;
  static constexpr auto in = [](Words words) { return std::string_view(words ? words : ""); };
  setup.draw_line = [](void* host, Words layer, Colour colour, double x1, double y1, double x2,
                       double y2) {
    const double numbers[] = {x1, y1, x2, y2};
    draw(host, {ThoughtKind::line, colour, in(layer), numbers, {}});
  };
  setup.draw_circle = [](void* host, Words layer, Colour colour, double x, double y,
                         double radius) {
    const double numbers[] = {x, y, radius};
    draw(host, {ThoughtKind::circle, colour, in(layer), numbers, {}});
  };
  setup.draw_polygon = [](void* host, Words layer, Colour colour, const double* points,
                          std::int32_t corners) {
    const auto numbers =
        points != nullptr && corners > 0 ? 2 * static_cast<std::size_t>(corners) : 0;
    const bool is_one = match::is_complete(ThoughtKind::polygon, numbers);
    draw(host, {ThoughtKind::polygon, colour, in(layer), {points, is_one ? numbers : 0}, {}});
  };
  setup.draw_text = [](void* host, Words layer, Colour colour, double x, double y, Words text) {
    const double numbers[] = {x, y};
    draw(host, {ThoughtKind::text, colour, in(layer), numbers, in(text)});
  };
}

}  // namespace mirocup::abi
