// SPDX-License-Identifier: MIT
//
// The functions of strategy.h with which a team draws, as one function of the program that runs it.
#pragma once

#include "core/match/thought.hpp"
#include "mirocup/strategy.h"

#include <algorithm>
#include <string_view>

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
  // A name is read up to its limit, wherever a team lets it end.
  static constexpr auto name = [](Words words) {
    if (words == nullptr) return std::string_view();
    return std::string_view(words, std::find(words, words + match::max_layer_name, '\0'));
  };
  setup.draw_line = [](void* host, Words layer, Colour colour, double x1, double y1, double x2,
                       double y2) {
    const double numbers[] = {x1, y1, x2, y2};
    draw(host, {ThoughtKind::line, colour, name(layer), numbers, {}});
  };
  setup.draw_circle = [](void* host, Words layer, Colour colour, double x, double y,
                         double radius) {
    const double numbers[] = {x, y, radius};
    draw(host, {ThoughtKind::circle, colour, name(layer), numbers, {}});
  };
  setup.draw_polygon = [](void* host, Words layer, Colour colour, const double* points,
                          std::int32_t corners) {
    const auto numbers =
        points != nullptr && corners > 0 ? 2 * static_cast<std::size_t>(corners) : 0;
    const bool is_one = match::is_complete(ThoughtKind::polygon, numbers);
    draw(host, {ThoughtKind::polygon, colour, name(layer), {points, is_one ? numbers : 0}, {}});
  };
  setup.draw_text = [](void* host, Words layer, Colour colour, double x, double y, Words text) {
    const double numbers[] = {x, y};
    draw(host, {ThoughtKind::text, colour, name(layer), numbers, in(text)});
  };
}

}  // namespace mirocup::abi
