// SPDX-License-Identifier: MIT
//
// Long texts inside a page: packed, so that the page stays small, and without characters of HTML's
// markup.
#pragma once

#include <string>
#include <string_view>

namespace mirocup::web {

// Returns the text as gzip in base64. A browser unpacks it with DecompressionStream('gzip'). The
// same text gives the same bytes.
std::string packed_text(std::string_view text);

}  // namespace mirocup::web
