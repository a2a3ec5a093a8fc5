// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace mirocup::system {

// Returns the text of a format of std::printf() with its values. The compiler compares their types
// with the format.
[[gnu::format(printf, 1, 2)]] std::string formatted(const char* format, ...);

}  // namespace mirocup::system
