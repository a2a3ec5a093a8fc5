// SPDX-License-Identifier: MIT
#include "labs/programs/old_text.hpp"

#include "system/printable.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace mirocup::labs {

namespace {

std::uint8_t byte_at(const std::string& text, std::size_t i) {
  return i < text.size() ? static_cast<std::uint8_t>(text[i]) : 0;
}

void append_utf8(std::string& out, std::uint32_t c) {
  const auto put = [&](std::uint32_t byte) { out.push_back(static_cast<char>(byte)); };
  if (c < 0x80) {
    put(c);
  } else if (c < 0x800) {
    put(0xc0 | c >> 6), put(0x80 | (c & 0x3f));
  } else if (c < 0x10000) {
    put(0xe0 | c >> 12), put(0x80 | (c >> 6 & 0x3f)), put(0x80 | (c & 0x3f));
  } else {
    put(0xf0 | c >> 18), put(0x80 | (c >> 12 & 0x3f)), put(0x80 | (c >> 6 & 0x3f));
    put(0x80 | (c & 0x3f));
  }
}

// `low`: where the low byte of a unit stands, 0 or 1. Behind the mark of two bytes.
std::string from_utf16(const std::string& text, std::size_t low) {
  std::string out;
  const auto unit = [&](std::size_t i) {
    return static_cast<std::uint32_t>(byte_at(text, i + low) | byte_at(text, i + 1 - low) << 8);
  };
  for (std::size_t i = 2; i + 1 < text.size(); i += 2) {
    std::uint32_t c = unit(i);
    const bool is_first_half = c >= 0xd800 && c < 0xdc00 && i + 3 < text.size();
    if (is_first_half) {
      c = 0x10000 + ((c - 0xd800) << 10) + ((unit(i + 2) - 0xdc00) & 0x3ff);
      i += 2;
    }
    append_utf8(out, c);
  }
  return out;
}

bool is_lead(std::uint8_t c) {
  return c >= 0x81 && c <= 0xfe;
}

// In GBK nearly all second bytes of Chinese text are above 127, in Latin-1 hardly a letter with an
// accent stands beside another one.
bool is_gbk(const std::string& text) {
  if (system::is_utf8(text)) return false;
  std::size_t high = 0, all = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (!is_lead(byte_at(text, i))) continue;
    const std::uint8_t second = byte_at(text, i + 1);
    if (second < 0x40 || second == 0x7f || second == 0xff) return false;
    ++all;
    if (second >= 0x80) ++high;
    ++i;
  }
  return 2 * high > all;
}

std::string with_plain_backslashes(const std::string& text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    out.push_back(text[i]);
    if (!is_lead(byte_at(text, i)) || i + 1 == text.size()) continue;
    ++i;
    if (text[i] == '\\') {
      out += "\\134";
    } else {
      out.push_back(text[i]);
    }
  }
  return out;
}

std::string with_single_returns(const std::string& text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const std::size_t end = std::min(text.find_first_not_of('\r', i), text.size());
    const bool is_line_end = end < text.size() && text[end] == '\n';
    out.append(text, i, end == i || is_line_end ? 1 : end - i);
    if (end > i) i = end - 1;
  }
  return out;
}

}  // namespace

std::string readable(std::string text) {
  const std::uint8_t first = byte_at(text, 0), second = byte_at(text, 1);
  if (first == 0xff && second == 0xfe) text = from_utf16(text, 0);
  if (first == 0xfe && second == 0xff) text = from_utf16(text, 1);
  constexpr char end_of_old_file = 26;
  while (!text.empty() && (text.back() == end_of_old_file || text.back() == '\0')) text.pop_back();
  if (is_gbk(text)) text = with_plain_backslashes(text);
  return with_single_returns(text);
}

}  // namespace mirocup::labs
