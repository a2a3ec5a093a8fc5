// SPDX-License-Identifier: MIT
//
// Escaping of text in pages. Names of teams are untrusted and must not become markup.
#pragma once

#include <string>
#include <string_view>

namespace mirocup::system {

// Returns `text` with character references for & < > " and ', for the text and the attribute values
// of HTML and SVG.
std::string html_escaped(std::string_view text);

}  // namespace mirocup::system
