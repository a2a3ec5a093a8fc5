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

// Returns the present moment, in seconds since 1970 UTC, by the computer's clock.
std::int64_t present_moment();

// Returns a moment as "2026-11-23 22:15 UTC".
std::string date_text(std::int64_t moment);

}  // namespace mirocup::system
