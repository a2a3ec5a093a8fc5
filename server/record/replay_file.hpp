// SPDX-License-Identifier: MIT
//
// The replay file beside a record: the commands of every tick and a hash of the state after each,
// zstd. schema.md has the bytes.
#pragma once

#include "core/base/error.hpp"
#include "core/match/match.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace mirocup::record {

std::string pack_replay(const std::vector<match::TickLog>& ticks, int robots);

// `path` is for the error message only. An error is Errc::damaged.
Result<std::vector<match::TickLog>> unpack_replay(std::string_view bytes, int robots,
                                                  const std::string& path);

}  // namespace mirocup::record
