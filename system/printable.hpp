// SPDX-License-Identifier: MIT
//
// Escaping of text that a stranger wrote, for a terminal, a log or a table: names of files, names
// of teams, the sentences and the output of a strategy.
#pragma once

#include <string>
#include <string_view>

namespace mirocup::system {

enum class LineEnds {
  escaped,  // the text is part of a line: it cannot begin a new line
  kept,     // the text is a log of lines
};

// Returns the text, in which \xNN replaces every byte that a terminal, a page or a reader could
// mistake for something else: control characters, bytes that are not UTF-8, and the characters that
// change the direction of writing. Tabs are kept, and line ends if `ends` says so. Text that is
// already escaped stays unchanged.
std::string printable(std::string_view text, LineEnds ends = LineEnds::escaped);

bool is_utf8(std::string_view text);

// Returns the first invisible character of a text in UTF-8, as "U+200B"; "" if all characters are
// visible. A joiner or a variation selector counts as invisible only at the beginning of the text,
// after itself, and after characters below U+0600 (the first Arabic character).
std::string hidden_character(std::string_view text);

// Returns a stranger's words as a part of a sentence: on one line, escaped, in double quotation
// marks that the text itself cannot close, and cut with "..." after max_quoted bytes.
inline constexpr std::size_t max_quoted = 240;  // bytes, escaped, without the marks
std::string in_quotes(std::string_view text);

}  // namespace mirocup::system
