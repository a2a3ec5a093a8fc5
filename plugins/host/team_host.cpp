// SPDX-License-Identifier: MIT
//
// This runs in a team's process, too, whose program is built without sanitizers and so must not
// need an object file of core.
#include "plugins/host/team_host.hpp"

#include "plugins/abi/drawing.hpp"
#include "plugins/host/plugin.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <iterator>
#include <span>
#include <string>
#include <string_view>

namespace mirocup::plugins {

namespace {

constexpr double full_turn = 6.2832;  // rad, rounded up
constexpr double far_away = 5.0;      // m

std::string short_text(double number) {
  char text[32];
  (void)std::snprintf(text, sizeof text, "%.4g", number);
  return text;
}

// Returns the page of the host; null if it keeps nothing of what is drawn.
ThoughtsPage* page_of(void* host) {
  return host == nullptr ? nullptr : static_cast<const TeamHost*>(host)->thoughts;
}

// Writes the line that make_line() returns to the log, unless a line was told before. The line is
// made only then, because a team draws and is asked in every tick.
template <class MakeLine>
void tell_once(bool& is_told, MakeLine make_line) {
  if (is_told) return;
  is_told = true;
  write_line((line_of_host + std::string(make_line())).c_str());
}

// Tells what the team's author would wonder about: a parameter that nobody can set.
void note_name(TeamHost& host, std::string_view name) {
  if (!match::is_parameter_name(name)) {
    tell_once(host.has_told_parameter, [&] {
      return "the team asks for the parameter \"" + std::string(name) +
             "\", which is no name: at most 31 letters, digits, '_', '-' and '.' are expected, a "
             "letter first";
    });
  }
  const std::size_t hash = std::hash<std::string_view>()(name);
  const auto end = host.names.begin() + static_cast<std::ptrdiff_t>(host.different_names);
  if (end == host.names.end() || std::find(host.names.begin(), end, hash) != end) return;
  *end = hash;
  if (++host.different_names == host.names.size()) {
    write_line((line_of_host +
                ("the team asks for more than " + std::to_string(match::max_team_parameters) +
                 " parameters, the most that a leg gives"))
                   .c_str());
  }
}

// Tells of what only the replay would show: shapes that nobody sees, and more shapes than there is
// room for in a tick. The colour 0 is that of the numbers of draw_value().
void note_shape(void* host, std::uint32_t colour, std::span<const double> numbers) {
  constexpr std::uint32_t opacity = 0xff;
  if (host == nullptr) return;
  auto& own = *static_cast<TeamHost*>(host);
  if ((colour & opacity) == 0 && colour != 0) {
    tell_once(own.has_told_colour, [&] {
      char text[16];
      (void)std::snprintf(text, sizeof text, "0x%08x", colour);
      return std::string("the team draws with the colour ") + text +
             ", which cannot be seen: the last byte of 0xRRGGBBAA is the opacity, and ff is opaque";
    });
  }
  if (!match::is_finite(numbers)) {
    tell_once(own.has_told_number, [] {
      return "the team draws at a place that is not finite; the replay leaves that shape out";
    });
  }
  if (++own.shapes <= match::max_thoughts) return;
  tell_once(own.has_told_shapes, [] {
    return "the team draws more than " + std::to_string(match::max_thoughts) +
           " shapes in a tick; the replay shows no more";
  });
}

// Puts a shape on the page of the host, if there is one.
void draw(void* host, const match::Thought& thought) {
  const auto& [kind, colour, layer, numbers, text] = thought;
  ThoughtsPage* page = page_of(host);
  if (numbers.empty()) {  // a polygon of too few or too many corners
    if (page != nullptr) ++page->left_out;
    return;
  }
  note_shape(host, colour, numbers);
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
  shape.layer[layer.copy(shape.layer, match::max_layer_name)] = '\0';
  std::copy(numbers.begin(), numbers.end(), page->number.data() + page->numbers);
  page->numbers += shape.numbers;
  std::copy(text.begin(), text.end(), page->texts.data() + page->text);
  page->text += shape.text;
}

}  // namespace

void give_host(mirocup_setup& setup, TeamHost& host) {
  setup.host = &host;
  setup.log = log_line;
  setup.parameter = parameter_of;
  abi::give_drawing<draw>(setup);
}

void log_line(void* host, const char* text) {
  if (text == nullptr) return;
  write_line(text);
  if (host != nullptr) static_cast<TeamHost*>(host)->last_line.assign(text, strnlen(text, 200));
}

std::string reason_in_log(const mirocup_setup& setup) {
  if (setup.log != log_line || setup.host == nullptr) return "";
  const std::string& line = static_cast<const TeamHost*>(setup.host)->last_line;
  return line.empty() ? "" : ": \"" + line + "\"";
}

double parameter_of(void* host, const char* name, double fallback) {
  if (host == nullptr || name == nullptr) return fallback;
  auto& own = *static_cast<TeamHost*>(host);
  note_name(own, name);
  for (std::uint32_t i = 0; i < own.table->count; ++i) {
    if (std::strcmp(own.table->rows[i].name, name) != 0) continue;
    own.asked->fetch_or(1U << i, std::memory_order_relaxed);
    return own.table->rows[i].value;
  }
  return fallback;
}

void note_units(TeamHost& host, const mirocup_placement& placement, std::int32_t robots) {
  for (std::int32_t i = 0; i < robots; ++i) {
    const mirocup_pose& pose = placement.robots[i];
    const auto robot = [i] { return "place() gave robot " + std::to_string(i); };
    if (std::abs(pose.heading) > full_turn) {
      tell_once(host.has_told_heading, [&] {
        return robot() + " the heading " + short_text(pose.heading) +
               ", which is more than a full turn: headings are in radians, and 90 degrees are "
               "1.5708";
      });
    }
    if (std::max(std::abs(pose.x), std::abs(pose.y)) > far_away) {
      tell_once(host.has_told_place, [&] {
        return robot() + " the place (" + short_text(pose.x) + ", " + short_text(pose.y) +
               "), which is outside of every pitch: places are in metres";
      });
    }
  }
  if (std::max(std::abs(placement.ball_x), std::abs(placement.ball_y)) > far_away)
    tell_once(host.has_told_place,
              [] { return "place() put the ball outside of every pitch: places are in metres"; });
}

void note_own_name(TeamHost& host, const std::string& name) {
  const bool is_plain =
      std::none_of(name.begin(), name.end(), [](char c) { return c > 0 && c < ' '; });
  if (is_plain && name.size() <= max_own_name) return;
  tell_once(host.has_told_name, [] {
    return "the team's name is not shown: it may have at most " + std::to_string(max_own_name) +
           " bytes, on one line";
  });
}

void note_command(TeamHost& host, const mirocup_command& command, std::int32_t robots) {
  const auto* end = std::end(command.wheels);
  const bool is_told = std::any_of(command.wheels + robots, end, [](const mirocup_wheels& wheels) {
    return wheels.left != 0.0 || wheels.right != 0.0;
  });
  if (!is_told) return;
  tell_once(host.has_told_robot, [&] {
    return "decide() set wheels of a robot that the team does not have: its robots are 0 to " +
           std::to_string(robots - 1);
  });
}

}  // namespace mirocup::plugins
