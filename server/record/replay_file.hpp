// SPDX-License-Identifier: MIT
//
// The replay file beside a record: the commands of every tick, a hash of the state after each, the
// trace of the bodies, and the poses that were asked for, zstd. schema.md has the bytes.
#pragma once

#include "core/base/error.hpp"
#include "core/replay/recording.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace mirocup::record {

struct Replay {
  std::vector<match::TickLog> ticks;
  std::vector<match::LoggedPlacementRequest> asked;
  replay::StateTrace trace;
};

// `robots` of a team.
std::string pack_replay(const replay::Recording& recording, int robots);

// `path` is for the error message only. An error is Errc::damaged.
Result<Replay> unpack_replay(std::string_view bytes, int robots, const std::string& path);

}  // namespace mirocup::record
