// SPDX-License-Identifier: MIT
#include "server/record/replay_file.hpp"

#include <cstring>
#include <zstd.h>

namespace mirocup::record {

namespace {

constexpr std::string_view magic = "mirocup/replay/1\n";
constexpr int compression_level = 12;
constexpr std::size_t most_ticks = 10'000'000;

void put(std::string& bytes, std::uint64_t value, int width) {
  for (int i = 0; i < width; ++i) bytes += static_cast<char>(value >> (8 * i));
}

std::uint64_t get(const std::string& bytes, std::size_t& at, int width) {
  std::uint64_t value = 0;
  for (int i = 0; i < width; ++i) {
    value |= static_cast<std::uint64_t>(static_cast<unsigned char>(bytes[at++])) << (8 * i);
  }
  return value;
}

std::size_t plain_size(std::size_t ticks, int robots) {
  return 8 + ticks * (2 * 2 * static_cast<std::size_t>(robots) * sizeof(std::int16_t) + 8);
}

}  // namespace

std::string pack_replay(const std::vector<match::TickLog>& ticks, int robots) {
  std::string plain;
  plain.reserve(plain_size(ticks.size(), robots));
  put(plain, ticks.size(), 4);
  put(plain, static_cast<std::uint64_t>(robots), 4);
  // Column by column, each as differences: commands change little from tick to tick.
  for (int team = 0; team < 2; ++team) {
    for (int i = 0; i < robots; ++i) {
      for (int wheel = 0; wheel < 2; ++wheel) {
        std::uint16_t before = 0;
        for (const match::TickLog& tick : ticks) {
          const auto now = static_cast<std::uint16_t>(tick.commands[team].wheels[i][wheel]);
          put(plain, static_cast<std::uint16_t>(now - before), 2);
          before = now;
        }
      }
    }
  }
  for (const match::TickLog& tick : ticks) put(plain, tick.hash, 8);

  std::string packed(magic);
  packed.resize(magic.size() + ZSTD_compressBound(plain.size()));
  const std::size_t size = ZSTD_compress(packed.data() + magic.size(), packed.size() - magic.size(),
                                         plain.data(), plain.size(), compression_level);
  packed.resize(magic.size() + size);
  return packed;
}

Result<std::vector<match::TickLog>> unpack_replay(std::string_view bytes, int robots,
                                                  const std::string& path) {
  const auto damaged = [&path](const char* why) { return fail(Errc::damaged, path + ": " + why); };
  if (bytes.substr(0, magic.size()) != magic) return damaged("this is not a replay of version 1");
  bytes.remove_prefix(magic.size());
  const unsigned long long size = ZSTD_getFrameContentSize(bytes.data(), bytes.size());
  if (size == ZSTD_CONTENTSIZE_ERROR || size == ZSTD_CONTENTSIZE_UNKNOWN ||
      size > plain_size(most_ticks, robots) || size < 8) {
    return damaged("the compressed data is damaged");
  }
  std::string plain(size, '\0');
  if (ZSTD_decompress(plain.data(), plain.size(), bytes.data(), bytes.size()) != size) {
    return damaged("the compressed data is damaged");
  }
  std::size_t at = 0;
  const std::size_t count = get(plain, at, 4);
  if (get(plain, at, 4) != static_cast<std::uint64_t>(robots)) {
    return damaged("it is of another number of robots than the record");
  }
  if (plain.size() != plain_size(count, robots))
    return damaged("its length does not fit its ticks");

  std::vector<match::TickLog> ticks(count);
  for (int team = 0; team < 2; ++team) {
    for (int i = 0; i < robots; ++i) {
      for (int wheel = 0; wheel < 2; ++wheel) {
        std::uint16_t value = 0;
        for (match::TickLog& tick : ticks) {
          value = static_cast<std::uint16_t>(value + get(plain, at, 2));
          tick.commands[team].wheels[i][wheel] = static_cast<std::int16_t>(value);
        }
      }
    }
  }
  for (match::TickLog& tick : ticks) tick.hash = get(plain, at, 8);
  return ticks;
}

}  // namespace mirocup::record
