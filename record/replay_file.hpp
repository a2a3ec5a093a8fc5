// SPDX-License-Identifier: MIT
//
// The replay file beside a record, compressed with zstd: for every tick the commands and a hash of
// the state after it, the trace of the bodies, and the poses that teams asked for. schema.md
// specifies the bytes.
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

// Returns the bytes of a replay file. `robots`: number of robots of a team.
std::string pack_replay(const replay::Recording& recording, int robots);

// Returns the bytes of pack_replay() before compression, and without the magic word.
std::string plain_replay(const replay::Recording& recording, int robots);

// The size of a replay according to its record.
struct ReplayShape {
  int robots = 0;         // number of robots of a team
  std::size_t ticks = 0;  // number of ticks of the leg
};

// Reads a replay from bytes, which may come from strangers. Decompresses at most the size of a
// replay of this shape, and no more ticks than the bytes can hold. The error is Errc::damaged and
// names `path`.
Result<Replay> unpack_replay(std::string_view bytes, const ReplayShape& shape,
                             const std::string& path);

// Reads a replay from uncompressed bytes, which may come from strangers.
Result<Replay> read_plain_replay(const std::string& plain, const ReplayShape& shape,
                                 const std::string& path);

}  // namespace mirocup::record
