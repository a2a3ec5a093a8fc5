// SPDX-License-Identifier: MIT
//
// Reads any bytes as a replay: the reader must return an error and never crash. The first byte
// chooses the league, and whether the harness compresses the bytes, since a fuzzer hardly finds a
// zstd frame by itself. The second chooses what the record says of its ticks.
#include "record/replay_file.hpp"
#include "tests/security/fuzz/fuzz_target.hpp"

#include <zstd.h>

MIROCUP_FUZZ_TARGET(replay) {
  if (size < 2) return;
  constexpr int robots[] = {3, 5, 11, 3};
  const std::uint8_t choice = data[0];
  std::size_t ticks = data[1] * (data[1] % 2 == 0 ? 1u : 65'537u);
  std::string bytes(mirocup::fuzz::text_of(data + 2, size - 2));
  if ((choice & 4) != 0) {
    // The number that the replay begins with is the one that a whole record would have.
    if (bytes.size() >= 2 && (choice & 8) != 0) {
      ticks = static_cast<unsigned char>(bytes[0]) + 256u * static_cast<unsigned char>(bytes[1]);
    }
    std::string packed(ZSTD_compressBound(bytes.size()), '\0');
    packed.resize(ZSTD_compress(packed.data(), packed.size(), bytes.data(), bytes.size(), 1));
    bytes = "mirocup/replay/2\n" + packed;
  }
  (void)mirocup::record::unpack_replay(bytes, {.robots = robots[choice & 3], .ticks = ticks},
                                       "leg.replay.zst");
}
