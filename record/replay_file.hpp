// SPDX-License-Identifier: MIT
//
// The replay file beside a record, compressed with zstd: the commands of every tick, a hash of the
// state after it, the trace of the bodies, and the poses that teams asked for. schema.md specifies
// the bytes.
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

// Returns the bytes of the file. `robots`: number of robots of a team.
std::string pack_replay(const replay::Recording& recording, int robots);

// What the record says of its replay.
struct ReplayShape {
  int robots = 0;         // of a team
  std::size_t ticks = 0;  // of the leg
};

// Reads the bytes, which may come from strangers: nothing is decompressed that is larger than a
// replay of this shape can be, or of more ticks than the bytes can hold. `path` is for the message
// of the error, which is Errc::damaged.
Result<Replay> unpack_replay(std::string_view bytes, const ReplayShape& shape,
                             const std::string& path);

}  // namespace mirocup::record
