// SPDX-License-Identifier: MIT
#include "system/markup.hpp"

namespace mirocup::system {

std::string html_escaped(std::string_view text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      case '\'':
        out += "&#39;";
        break;
      default:
        out += c;
    }
  }
  return out;
}

std::string percent_coded(std::string_view text) {
  constexpr char hex[] = "0123456789ABCDEF";
  std::string coded;
  for (const unsigned char c : text) {
    const bool is_plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                          (c >= '0' && c <= '9') || c == '-' || c == '_' || c == '.';
    if (is_plain) {
      coded += static_cast<char>(c);
    } else {
      coded += {'%', hex[c >> 4], hex[c & 15]};
    }
  }
  return coded;
}

}  // namespace mirocup::system
