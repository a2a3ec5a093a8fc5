// SPDX-License-Identifier: MIT
//
// SHA-256 digests, and base64 (RFC 4648, with padding).
#pragma once

#include <string>
#include <string_view>

namespace mirocup::system {

// Returns the digest as 64 lower-case hexadecimal digits.
std::string sha256(std::string_view bytes);

// Returns the digest's 32 bytes in base64, as a content security policy names a script.
std::string sha256_base64(std::string_view bytes);

std::string base64(std::string_view bytes);

}  // namespace mirocup::system
