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

// Returns the last line of what a program printed, without its end.
std::string last_line(std::string text);

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

// Returns the text that std::printf() prints for this format and these values. The compiler
// compares the types of the values with the format.
[[gnu::format(printf, 1, 2)]] std::string formatted(const char* format, ...);

// Returns a word that a POSIX shell reads as this text: the text itself if it has only plain
// characters, otherwise the text in single quotation marks.
std::string shell_word(const std::string& text);

// Escaping of text in pages and addresses: names of teams are untrusted and must not become markup.

// Returns `text` with character references for & < > " and ', for the text and the attribute values
// of HTML and SVG.
std::string html_escaped(std::string_view text);

// Returns `text` as a part of an address, or as the name of a partition or of a file: bytes other
// than letters, digits, '-', '_' and '.' are coded with a percent sign.
std::string percent_coded(std::string_view text);

}  // namespace mirocup::system
