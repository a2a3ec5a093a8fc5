// SPDX-License-Identifier: MIT
//
// Common operations on texts. Letters and digits are those of ASCII.
#pragma once

#include <string>
#include <string_view>

namespace mirocup::system {

// True for a letter, a digit, "-", "_" and ".", which may stand in any name of a file or in a URL.
bool is_plain(char c);

// Returns the text with the letters A to Z as a to z.
std::string lower_case(std::string text);

// Returns the text with `by` in the place of each `word`.
std::string replaced(std::string text, std::string_view word, std::string_view by);

// Returns the words, of which none is empty, in one text with `between` between two of them.
template <class Words>
std::string joined(const Words& words, std::string_view between) {
  std::string text;
  for (const std::string_view word : words) {
    if (!text.empty()) text += between;
    text += word;
  }
  return text;
}

}  // namespace mirocup::system
