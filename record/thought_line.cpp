// SPDX-License-Identifier: MIT
#include "record/thought_line.hpp"

#include "system/printable.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace mirocup::record {

namespace {

constexpr std::uint32_t units_per_metre = 10'000;  // 0.1 mm
constexpr double furthest = 1e3;            // m; what is further away is no part of a picture
constexpr std::size_t most_of_number = 10;  // bytes of "-1000.1234"

// Writes at most most_of_number bytes and returns their end. Zeros at the end are left out.
char* put_metres(char* out, double metres) {
  const double bounded = std::clamp(metres, -furthest, furthest) * units_per_metre;
  const auto rounded = static_cast<std::int32_t>(bounded + std::copysign(0.5, bounded));
  if (rounded < 0) *out++ = '-';
  const auto units = static_cast<std::uint32_t>(std::abs(rounded));
  const std::uint32_t whole = units / units_per_metre;
  const std::uint32_t rest = units % units_per_metre;
  out = std::to_chars(out, out + 4, whole).ptr;
  if (rest == 0) return out;
  *out++ = '.';
  for (std::uint32_t unit = units_per_metre / 10; unit > 0; unit /= 10)
    *out++ = static_cast<char>('0' + rest / unit % 10);
  while (out[-1] == '0') --out;
  return out;
}

char* put_numbers(char* out, std::span<const double> numbers) {
  for (const double number : numbers) {
    out = put_metres(out, number);
    *out++ = ',';
  }
  return numbers.empty() ? out : out - 1;
}

char* put_corners(char* out, std::span<const double> numbers) {
  for (std::size_t i = 0; i + 1 < numbers.size(); i += 2) {
    *out++ = '[';
    out = put_numbers(out, numbers.subspan(i, 2));
    *out++ = ']';
    *out++ = ',';
  }
  return numbers.size() < 2 ? out : out - 1;
}

// Appends #RRGGBBAA.
void append_colour(std::string& line, std::uint32_t colour) {
  constexpr std::string_view digits = "0123456789abcdef";
  char text[9]{'#'};
  for (std::size_t i = 8; i > 0; --i, colour >>= 4) text[i] = digits[colour & 15u];
  line.append(text, sizeof text);
}

// Appends foreign text as a JSON string.
void append_text(std::string& line, std::string_view text) {
  line += '"';
  for (const char c : system::printable(text)) {
    if (c == '"' || c == '\\') line += '\\';
    line += c == '\t' ? ' ' : c;
  }
  line += '"';
}

}  // namespace

void ThoughtLine::write_head(std::uint32_t tick, const match::Thought& thought) {
  if (head_ == 0 || tick != head_tick_) {
    line_ = "{\"tick\":" + std::to_string(tick) + ",\"layer\":";
    tick_ = line_.size();
    head_tick_ = tick;
  }
  line_.resize(tick_);
  append_text(line_, thought.layer);
  line_ += ",\"colour\":\"";
  append_colour(line_, thought.colour);
  line_ += "\",\"";
  line_ += to_string(thought.kind);
  line_ += "\":[";
  head_ = line_.size();
  kind_ = thought.kind;
  colour_ = thought.colour;
  layer_ = thought.layer;
}

void ThoughtLine::write_tail(const match::Thought& thought) {
  // Each number with a comma, or two of them with a comma in brackets with a comma.
  std::array<char, (2 * match::max_polygon_corners) * (most_of_number + 3)> numbers;
  const auto bounded = thought.numbers.first(
      std::min(thought.numbers.size(), std::size_t{2} * match::max_polygon_corners));
  const char* end = thought.kind == match::ThoughtKind::polygon
                        ? put_corners(numbers.data(), bounded)
                        : put_numbers(numbers.data(), bounded);
  line_.append(numbers.data(), static_cast<std::size_t>(end - numbers.data()));
  if (thought.kind == match::ThoughtKind::text) {
    line_ += ',';
    append_text(line_, thought.text);
  }
  line_ += "]}\n";
}

std::string_view ThoughtLine::write(std::uint32_t tick, const match::Thought& thought) {
  const bool has_head = head_ > 0 && tick == head_tick_ && thought.kind == kind_ &&
                        thought.colour == colour_ && thought.layer == layer_;
  if (!has_head) write_head(tick, thought);
  line_.resize(head_);
  write_tail(thought);
  return line_;
}

}  // namespace mirocup::record
