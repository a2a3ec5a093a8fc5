// SPDX-License-Identifier: MIT
//
// Reads any bytes as a replay: the reader must return an error and never crash. The first byte
// chooses the league, and whether the harness compresses the bytes, since a fuzzer hardly finds a
// zstd frame by itself.
#include "server/record/replay_file.hpp"

#include <cstddef>
#include <cstdint>
#include <zstd.h>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  constexpr int robots[] = {3, 5, 11, 3};
  const std::uint8_t choice = *data;
  std::string bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
  if ((choice & 4) != 0) {
    std::string packed(ZSTD_compressBound(bytes.size()), '\0');
    packed.resize(ZSTD_compress(packed.data(), packed.size(), bytes.data(), bytes.size(), 1));
    bytes = "mirocup/replay/2\n" + packed;
  }
  (void)mirocup::record::unpack_replay(bytes, robots[choice & 3], "leg.replay.zst");
  return 0;
}
