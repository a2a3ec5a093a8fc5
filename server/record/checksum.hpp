// SPDX-License-Identifier: MIT
//
// The last key of a record is the digest of the text before it. It finds every byte that was
// changed or lost. It does not prevent forgery.
#pragma once

#include "core/base/error.hpp"

#include <string>

namespace mirocup::record {

// Adds the key to the text of an object with at least one key, one key a line.
std::string with_checksum(std::string object);

// Whether the text of a record is what was written. Errors: Errc::damaged, with the path.
Result<void> expect_whole(const std::string& text, const std::string& path);

}  // namespace mirocup::record
