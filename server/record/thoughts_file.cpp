// SPDX-License-Identifier: MIT
#include "server/record/thoughts_file.hpp"

#include "system/printable.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <zstd.h>

namespace mirocup::record {

namespace {

// The lines are alike, so the lowest level packs them to a tenth already.
constexpr int thoughts_level = 1;

constexpr double units_per_metre = 1e4;  // 0.1 mm
constexpr double furthest = 1e3;         // m; what is further away is no part of a picture

template <class Number>
void append_whole(std::string& line, Number number) {
  char digits[24];
  line.append(digits, std::to_chars(digits, digits + sizeof digits, number).ptr);
}

void append_metres(std::string& line, double metres) {
  const double bounded = std::clamp(metres, -furthest, furthest);
  auto units = static_cast<std::int64_t>(std::lround(bounded * units_per_metre));
  if (units < 0) {
    line += '-';
    units = -units;
  }
  constexpr auto scale = static_cast<std::int64_t>(units_per_metre);
  append_whole(line, units / scale);
  auto rest = static_cast<std::uint32_t>(units % scale);
  if (rest == 0) return;
  char text[5]{'.'};
  std::size_t length = 1;
  for (std::uint32_t digit = scale / 10; rest > 0; digit /= 10) {
    text[length++] = static_cast<char>('0' + rest / digit);
    rest %= digit;
  }
  line.append(text, length);
}

// Appends #RRGGBBAA.
void append_colour(std::string& line, std::uint32_t colour) {
  constexpr std::string_view digits = "0123456789abcdef";
  char text[9]{'#'};
  for (std::size_t i = 8; i > 0; --i, colour >>= 4) text[i] = digits[colour & 15u];
  line.append(text, sizeof text);
}

bool is_plain(char c) {
  return c >= ' ' && c <= '~' && c != '"' && c != '\\';
}

// Appends foreign text as a JSON string.
void append_text(std::string& line, std::string_view text) {
  line += '"';
  if (std::all_of(text.begin(), text.end(), is_plain)) {
    line += text;
  } else {
    for (const char c : system::printable(text)) {
      if (c == '"' || c == '\\') line += '\\';
      line += c == '\t' ? ' ' : c;
    }
  }
  line += '"';
}

void append_numbers(std::string& line, std::span<const double> numbers) {
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (i > 0) line += ',';
    append_metres(line, numbers[i]);
  }
}

void append_corners(std::string& line, std::span<const double> numbers) {
  for (std::size_t i = 0; i + 1 < numbers.size(); i += 2) {
    line += i > 0 ? ",[" : "[";
    append_numbers(line, numbers.subspan(i, 2));
    line += ']';
  }
}

}  // namespace

std::string thoughts_path(const std::string& record_path, Team team) {
  const std::string ending = "." + std::string(to_string(team)) + ".thoughts.zst";
  return std::filesystem::path(record_path).replace_extension().string() + ending;
}

void ThoughtsWriter::add(std::uint32_t tick, const match::Thought& thought) {
  const std::size_t before = lines_.size();
  last_tick_ = tick;
  lines_ += "{\"tick\":";
  append_whole(lines_, tick);
  lines_ += ",\"layer\":";
  append_text(lines_, thought.layer);
  lines_ += ",\"colour\":\"";
  append_colour(lines_, thought.colour);
  lines_ += "\",\"";
  lines_ += to_string(thought.kind);
  lines_ += "\":[";
  if (thought.kind == match::ThoughtKind::polygon) {
    append_corners(lines_, thought.numbers);
  } else {
    append_numbers(lines_, thought.numbers);
  }
  if (thought.kind == match::ThoughtKind::text) {
    lines_ += ',';
    append_text(lines_, thought.text);
  }
  lines_ += "]}\n";
  if (lines_.size() <= match::max_thought_bytes) return;
  lines_.resize(before);
  ++left_out_;
}

std::string ThoughtsWriter::packed() {
  if (left_out_ > 0) {
    lines_ += "{\"tick\":" + std::to_string(last_tick_) +
              ",\"layer\":\"mirocup\",\"colour\":\"#808080ff\",\"text\":[0,0,\"" +
              std::to_string(left_out_) + " shapes of the leg were left out\"]}\n";
    left_out_ = 0;
  }
  std::string bytes(ZSTD_compressBound(lines_.size()), '\0');
  const std::size_t size =
      ZSTD_compress(bytes.data(), bytes.size(), lines_.data(), lines_.size(), thoughts_level);
  bytes.resize(ZSTD_isError(size) ? 0 : size);
  return bytes;
}

Result<std::string> unpacked_thoughts(std::string_view bytes, const std::string& path) {
  const unsigned long long size = ZSTD_getFrameContentSize(bytes.data(), bytes.size());
  constexpr std::size_t note = 1024;  // of the line about what was left out
  if (size == ZSTD_CONTENTSIZE_ERROR || size == ZSTD_CONTENTSIZE_UNKNOWN ||
      size > match::max_thought_bytes + note) {
    return fail(Errc::damaged, path + ": these are no thoughts of a leg");
  }
  std::string lines(size, '\0');
  const std::size_t got = ZSTD_decompress(lines.data(), lines.size(), bytes.data(), bytes.size());
  if (ZSTD_isError(got) || got != lines.size())
    return fail(Errc::damaged, path + ": the thoughts are damaged");
  return lines;
}

}  // namespace mirocup::record
