// SPDX-License-Identifier: MIT
//
// The time at which certificates expire.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace mirocup::system {

// Returns the moment until which a certificate (PEM) is valid, in seconds since 1970 UTC; nothing
// if the text is not a certificate.
std::optional<std::int64_t> certificate_end(std::string_view pem);

}  // namespace mirocup::system
