// SPDX-License-Identifier: MIT
//
// This runs in a team's process, too, whose program is built without sanitizers and so must not
// need an object file of core.
#include "plugins/host/team_host.hpp"

#include <algorithm>
#include <cstring>
#include <span>
#include <string_view>

namespace mirocup::plugins {

namespace {

using match::ThoughtKind;

// Returns the page of the host; null if it keeps nothing of what is drawn.
ThoughtsPage* page_of(void* host) {
  return host == nullptr ? nullptr : static_cast<const TeamHost*>(host)->thoughts;
}

// Puts a shape on the page of the host, if there is one.
void draw(void* host, ThoughtKind kind, const char* layer, std::uint32_t colour,
          std::span<const double> numbers, std::string_view text = {}) {
  ThoughtsPage* page = page_of(host);
  if (page == nullptr) return;
  const bool has_room = page->shapes < page->shape.size() &&
                        page->numbers + numbers.size() <= page->number.size() &&
                        page->text + text.size() <= page->texts.size();
  if (!has_room || !match::is_finite(numbers)) {
    ++page->left_out;
    return;
  }
  ThoughtsPage::Shape& shape = page->shape[page->shapes++];
  shape.kind = kind;
  shape.colour = colour;
  shape.numbers = static_cast<std::uint32_t>(numbers.size());
  shape.text = static_cast<std::uint32_t>(text.size());
  const std::size_t name = layer == nullptr ? 0 : strnlen(layer, match::max_layer_name);
  if (name > 0) std::memcpy(shape.layer, layer, name);
  shape.layer[name] = '\0';
  std::copy(numbers.begin(), numbers.end(), page->number.data() + page->numbers);
  page->numbers += shape.numbers;
  std::copy(text.begin(), text.end(), page->texts.data() + page->text);
  page->text += shape.text;
}

}  // namespace

void give_host(mirocup_setup& setup, TeamHost& host) {
  setup.host = &host;
  setup.parameter = parameter_of;
  setup.draw_line = draw_line;
  setup.draw_circle = draw_circle;
  setup.draw_polygon = draw_polygon;
  setup.draw_text = draw_text;
}

double parameter_of(void* host, const char* name, double fallback) {
  if (host == nullptr || name == nullptr) return fallback;
  const auto& own = *static_cast<const TeamHost*>(host);
  for (std::uint32_t i = 0; i < own.table->count; ++i) {
    if (std::strcmp(own.table->rows[i].name, name) != 0) continue;
    own.asked->fetch_or(1U << i, std::memory_order_relaxed);
    return own.table->rows[i].value;
  }
  return fallback;
}

void draw_line(void* host, const char* layer, std::uint32_t colour, double x1, double y1, double x2,
               double y2) {
  const double numbers[] = {x1, y1, x2, y2};
  draw(host, ThoughtKind::line, layer, colour, numbers);
}

void draw_circle(void* host, const char* layer, std::uint32_t colour, double x, double y,
                 double radius) {
  const double numbers[] = {x, y, radius};
  draw(host, ThoughtKind::circle, layer, colour, numbers);
}

void draw_polygon(void* host, const char* layer, std::uint32_t colour, const double* points,
                  std::int32_t corners) {
  constexpr auto most = static_cast<std::int32_t>(match::max_polygon_corners);
  if (points == nullptr || corners < 3 || corners > most) {
    if (ThoughtsPage* page = page_of(host)) ++page->left_out;
    return;
  }
  draw(host, ThoughtKind::polygon, layer, colour, {points, 2 * static_cast<std::size_t>(corners)});
}

void draw_text(void* host, const char* layer, std::uint32_t colour, double x, double y,
               const char* text) {
  const double numbers[] = {x, y};
  draw(host, ThoughtKind::text, layer, colour, numbers, text == nullptr ? "" : text);
}

}  // namespace mirocup::plugins
