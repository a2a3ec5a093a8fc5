// SPDX-License-Identifier: MIT
//
// A recording as plain bytes, so that core alone can read it: no JSON, no zstd. Structs are copied
// as they lie in memory: for machines that agree in sizes and byte order, as x86-64 and arm64 do,
// and for programs of the same sources. record writes the records that are kept.
#pragma once

#include "core/replay/recording.hpp"

#include <optional>
#include <string>

namespace mirocup::test_support {

std::string flat(const replay::Recording& recording);

// Returns nothing if the bytes are no recording of these sources.
std::optional<replay::Recording> recording_from(const std::string& bytes);

}  // namespace mirocup::test_support
