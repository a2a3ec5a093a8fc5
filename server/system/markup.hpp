// SPDX-License-Identifier: MIT
//
// Text that becomes part of a page. Names of teams come from strangers: none of them may turn into
// markup.
#pragma once

#include <string>
#include <string_view>

namespace mirocup::system {

// For text and for attribute values of HTML and SVG.
std::string html_escaped(std::string_view text);

}  // namespace mirocup::system
