// SPDX-License-Identifier: MIT
//
// Escaping of text in pages and addresses. Names of teams are untrusted and must not become markup.
#pragma once

#include <string>
#include <string_view>

namespace mirocup::system {

// Returns `text` with character references for & < > " and ', for the text and the attribute values
// of HTML and SVG.
std::string html_escaped(std::string_view text);

// Returns `text` as a part of an address, or as the name of a partition or of a file: bytes other
// than letters, digits, '-', '_' and '.' are coded with a percent sign.
std::string percent_coded(std::string_view text);

}  // namespace mirocup::system
