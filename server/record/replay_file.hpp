// SPDX-License-Identifier: MIT
//
// The replay file beside a record: the commands of every tick, a hash of the state after each, and
// the trace of the bodies, zstd. schema.md has the bytes.
#pragma once

#include "core/base/error.hpp"
#include "core/replay/trace.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace mirocup::record {

struct Replay {
  std::vector<match::TickLog> ticks;
  replay::Trace trace;
};

// `robots` of a team.
std::string pack_replay(const std::vector<match::TickLog>& ticks, const replay::Trace& trace,
                        int robots);

// `path` is for the error message only. An error is Errc::damaged.
Result<Replay> unpack_replay(std::string_view bytes, int robots, const std::string& path);

}  // namespace mirocup::record
