// SPDX-License-Identifier: MIT
#include "system/printable.hpp"

#include "system/text.hpp"

#include <algorithm>
#include <cstdint>

namespace mirocup::system {

namespace {

struct Character {
  std::size_t length = 0;  // bytes; 0: not UTF-8
  std::uint32_t code = 0;
};

Character first_of(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char lead = byte(0);
  if (lead < 0x80) return {1, lead};
  const std::size_t length = lead >= 0xf0 ? 4 : lead >= 0xe0 ? 3 : 2;
  if (lead < 0xc2 || lead > 0xf4 || text.size() < length) return {};
  std::uint32_t code = lead & (0x7fu >> length);
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xc0) != 0x80) return {};
    code = code << 6 | (byte(i) & 0x3f);
  }
  const bool is_too_long = (length == 3 && code < 0x800) || (length == 4 && code < 0x10000);
  const bool is_surrogate = code >= 0xd800 && code < 0xe000;
  if (is_too_long || is_surrogate || code > 0x10ffff) return {};
  return {length, code};
}

bool is_harmless(std::uint32_t code, LineEnds ends) {
  if (code == '\n') return ends == LineEnds::kept;
  if (code == '\t') return true;
  if (code < 0x20 || (code >= 0x7f && code < 0xa0)) return false;
  // Characters that change the direction of writing, or end a line only in some programs.
  const bool turns = code == 0x61c || (code >= 0x200e && code <= 0x200f) ||
                     (code >= 0x2028 && code <= 0x202e) || (code >= 0x2066 && code <= 0x2069);
  return !turns && code != 0xfeff;
}

}  // namespace

std::string printable(std::string_view text, LineEnds ends) {
  constexpr char digits[] = "0123456789abcdef";
  std::string out;
  out.reserve(text.size());
  while (!text.empty()) {
    const Character c = first_of(text);
    const std::size_t length = std::max<std::size_t>(c.length, 1);
    if (c.length > 0 && is_harmless(c.code, ends)) {
      out += text.substr(0, length);
    } else {
      for (const char byte : text.substr(0, length)) {
        const auto value = static_cast<unsigned char>(byte);
        out += {'\\', 'x', digits[value >> 4], digits[value & 15]};
      }
    }
    text.remove_prefix(length);
  }
  return out;
}

bool is_utf8(std::string_view text) {
  while (!text.empty()) {
    const std::size_t length = first_of(text).length;
    if (length == 0) return false;
    text.remove_prefix(length);
  }
  return true;
}

std::string hidden_character(std::string_view text) {
  constexpr std::uint32_t first_joined = 0x600;  // the first writing whose letters are joined
  std::uint32_t before = 0;
  while (!text.empty()) {
    const Character c = first_of(text);
    const std::uint32_t code = c.code;
    const bool joins = code == 0x200c || code == 0x200d || (code >= 0xfe00 && code <= 0xfe0f);
    const bool is_hidden =
        joins ? before < first_joined || before == code
              : code == 0xad || code == 0x34f || code == 0x115f || code == 0x1160 ||
                    code == 0x17b4 || code == 0x17b5 || (code >= 0x180b && code <= 0x180e) ||
                    code == 0x200b || (code >= 0x202a && code <= 0x202e) ||
                    (code >= 0x2060 && code <= 0x206f) || code == 0x3164 || code == 0xfeff ||
                    code == 0xffa0 || (code >= 0xfff0 && code <= 0xfffb) ||
                    (code >= 0x1d173 && code <= 0x1d17a) || (code >= 0xe0000 && code <= 0xe0fff);
    if (is_hidden) return formatted("U+%04X", static_cast<unsigned>(code));
    before = code;
    text.remove_prefix(std::max<std::size_t>(c.length, 1));
  }
  return "";
}

std::string in_quotes(std::string_view text) {
  std::string out = "\"";
  while (!text.empty()) {
    const std::size_t length = std::max<std::size_t>(first_of(text).length, 1);
    const std::string_view first = text.substr(0, length);
    std::string shown = printable(first);
    if (first == "\n") shown = "\\n";
    if (first == "\t") shown = "\\t";
    if (first == "\"") shown = "'";
    if (out.size() + shown.size() > 1 + max_quoted) return out + "...\"";
    out += shown;
    text.remove_prefix(length);
  }
  return out + '"';
}

}  // namespace mirocup::system
