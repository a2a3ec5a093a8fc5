// SPDX-License-Identifier: MIT
//
// SHA-256, as 64 lower-case hexadecimal digits.
#pragma once

#include <string>
#include <string_view>

namespace mirocup::system {

std::string sha256(std::string_view bytes);

}  // namespace mirocup::system
