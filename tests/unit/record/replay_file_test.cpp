// SPDX-License-Identifier: MIT
//
// Catches a replay that takes more memory than its record can need.
#include "record/replay_file.hpp"

#include "core/field/field.hpp"
#include "tests/support/is_ok.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <sys/resource.h>
#include <zstd.h>

namespace mirocup::record {
namespace {

constexpr int robots = 3;

replay::Recording recording_of(std::size_t ticks) {
  replay::Recording recording;
  recording.ticks.resize(ticks);
  return recording;
}

// The error of a replay of this text, before compression.
std::string error_of(const std::string& plain, std::size_t ticks) {
  std::string packed(ZSTD_compressBound(plain.size()), '\0');
  packed.resize(ZSTD_compress(packed.data(), packed.size(), plain.data(), plain.size(), 1));
  return test_support::why_not(
      unpack_replay("mirocup/replay/2\n" + packed, {.robots = robots, .ticks = ticks}, "r"));
}

TEST(ReplayFile, IsOfTheShapeThatTheRecordSays) {
  const std::string bytes = pack_replay(recording_of(100), robots);
  const auto error = [&](int of_team, std::size_t ticks) {
    return test_support::why_not(unpack_replay(bytes, {.robots = of_team, .ticks = ticks}, "r"));
  };
  EXPECT_EQ(error(robots, 100), "");
  EXPECT_EQ(error(11, 100), "r: it has another number of robots than the record");
  EXPECT_EQ(error(robots, 99), "r: it has another number of ticks than the record says");
}

// 568 KB took 1.97 GB. What is refused here is not decompressed: the text says so.
TEST(ReplayFile, DecompressesNoMoreThanTheRecordNeeds) {
  EXPECT_EQ(error_of(std::string(16u << 20, '\0'), 100), "r: the compressed data is damaged");
  EXPECT_EQ(error_of(std::string(16u << 20, '\0'), 4'000'000),
            "r: it is too short for the ticks of the record");
  EXPECT_EQ(error_of("", SIZE_MAX), "r: it is too short for the ticks of the record");
}

std::size_t peak_mebibytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::size_t>(usage.ru_maxrss) >> 10;
}

// Of a leg of 30 hours, 16 MB may say that they have answers at restarts in every tick: 2 GiB.
TEST(ReplayFile, TakesAGibibyteAtMost) {
  std::string frame("\x28\xb5\x2f\xfd\xe0", 5);  // with eight bytes of size
  for (int i = 0; i < 8; ++i) frame += static_cast<char>((std::uint64_t{2} << 30) >> (8 * i));
  frame += std::string(16u << 20, '\0');
  const std::size_t before = peak_mebibytes();
  const auto replay =
      unpack_replay("mirocup/replay/2\n" + frame, {.robots = 11, .ticks = 4'000'000}, "r");
  ASSERT_FALSE(replay);
  EXPECT_EQ(replay.error().what, "r: the compressed data is damaged");
  EXPECT_LT(peak_mebibytes() - before, 200u) << "of memory";
}

TEST(ReplayFile, HasOneFrame) {
  const std::string bytes = pack_replay(recording_of(100), robots);
  const std::string frame = bytes.substr(bytes.find('\n') + 1);
  EXPECT_FALSE(unpack_replay(bytes + frame, {.robots = robots, .ticks = 100}, "r"));
  EXPECT_FALSE(unpack_replay(bytes + "rest", {.robots = robots, .ticks = 100}, "r"));
}

}  // namespace
}  // namespace mirocup::record
