// SPDX-License-Identifier: MIT
#include "system/markup.hpp"

#include "system/text.hpp"

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
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    coded += is_plain(c) ? std::string{c} : std::string{'%', hex[byte >> 4], hex[byte & 15]};
  }
  return coded;
}

}  // namespace mirocup::system
