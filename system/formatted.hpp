// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace mirocup::system {

// Returns the text that std::printf() prints for this format and these values. The compiler
// compares the types of the values with the format.
[[gnu::format(printf, 1, 2)]] std::string formatted(const char* format, ...);

}  // namespace mirocup::system
