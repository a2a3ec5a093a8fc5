// SPDX-License-Identifier: MIT
#include "record/replay_file.hpp"

#include <algorithm>
#include <bit>
#include <cassert>
#include <zstd.h>

namespace mirocup::record {

namespace {

constexpr std::string_view magic = "mirocup/replay/2\n";
// Most of a replay is hashes, which cannot be compressed. The highest levels save 1 % and take 20
// times as long, which is a tenth of the time of a whole leg.
constexpr int compression_level = 1;
constexpr std::size_t head_size = 16;

// The longest legs: two halves of ten hours at 60 ticks a second, and their stoppages.
constexpr std::size_t max_ticks = 5'000'000;
// A tick has a hash of 8 bytes, which cannot be compressed. What has less than half of it for each
// tick is made up. Short legs may be.
constexpr std::size_t min_bytes_per_tick = 4;
constexpr std::size_t always_allowed_ticks = 4096;
// Compressed, answers at restarts in every tick need next to nothing. Longest legs need 700 MiB.
constexpr std::size_t max_plain_bytes = 1u << 30;

// The file has 0 for blue and 1 for yellow, and a team's commands at that index.
static_assert(index_of(Team::blue) == 0 && index_of(Team::yellow) == 1);
static_assert(both_teams == std::array{Team::blue, Team::yellow});

// The numbers of parts of a replay.
struct Counts {
  std::size_t ticks = 0;
  std::size_t robots = 0;        // of a team
  std::size_t fingerprints = 0;  // 0 or ticks
  std::size_t checkpoints = 0;

  std::size_t bodies() const { return 2 * robots + 1; }
  std::size_t plain_size() const {
    const std::size_t commands = 2 * 2 * robots * sizeof(std::int16_t);
    const std::size_t checkpoint = (2 * robots * 7 + 4) * sizeof(double);
    return head_size + ticks * (commands + 8) + fingerprints * bodies() + checkpoints * checkpoint;
  }
  // The bytes of one team's answer at a restart.
  std::size_t asked_size() const { return 4 + 1 + (2 + 3 * robots) * sizeof(double); }
};

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

// Calls visit(number) for each number of a checkpoint, in the order of the file.
template <class C, class Visit>
void for_each_number(C& checkpoint, std::size_t robots, Visit visit) {
  for (std::size_t i = 0; i < 2 * robots; ++i) {
    auto& robot = checkpoint.robots[i];
    visit(robot.position.x());
    visit(robot.position.y());
    visit(robot.heading.cos);
    visit(robot.heading.sin);
    visit(robot.twist.forward);
    visit(robot.twist.left);
    visit(robot.twist.omega);
  }
  visit(checkpoint.ball.position.x());
  visit(checkpoint.ball.position.y());
  visit(checkpoint.ball.velocity.x());
  visit(checkpoint.ball.velocity.y());
}

// The same for the poses that a team asked for.
template <class P, class Visit>
void for_each_asked_number(P& poses, std::size_t robots, Visit visit) {
  visit(poses.ball_x);
  visit(poses.ball_y);
  for (std::size_t i = 0; i < robots; ++i) {
    visit(poses.robots[i].x);
    visit(poses.robots[i].y);
    visit(poses.robots[i].heading);
  }
}

void put_asked(std::string& plain, const std::vector<match::LoggedPlacementRequest>& asked,
               std::size_t robots) {
  for (const match::LoggedPlacementRequest& logged : asked) {
    put(plain, logged.tick, 4);
    put(plain, static_cast<std::uint64_t>(index_of(logged.team)), 1);
    for_each_asked_number(logged.request, robots, [&plain](double number) {
      put(plain, std::bit_cast<std::uint64_t>(number), 8);
    });
  }
}

// Reads the answers at restarts. Returns false if one has no valid team, or if they are not in the
// order of the ticks.
bool get_asked(const std::string& plain, std::size_t& at,
               std::vector<match::LoggedPlacementRequest>& asked, std::size_t robots) {
  for (match::LoggedPlacementRequest& logged : asked) {
    logged.tick = static_cast<std::uint32_t>(get(plain, at, 4));
    const std::uint64_t team = get(plain, at, 1);
    if (team >= both_teams.size()) return false;
    logged.team = both_teams[team];
    for_each_asked_number(logged.request, robots, [&](double& number) {
      number = std::bit_cast<double>(get(plain, at, 8));
    });
  }
  return std::is_sorted(asked.begin(), asked.end(),
                        [](const match::LoggedPlacementRequest& a,
                           const match::LoggedPlacementRequest& b) { return a.tick < b.tick; });
}

// Column by column, each as differences: commands change little from tick to tick.
void put_commands(std::string& plain, const std::vector<match::TickLog>& ticks, int robots) {
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
}

void get_commands(const std::string& plain, std::size_t& at, std::vector<match::TickLog>& ticks,
                  int robots) {
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
}

// The largest number of bytes of a replay of this shape, before compression: with a trace, and with
// an answer of each team in every tick.
std::size_t largest_size(const ReplayShape& shape) {
  const Counts most{.ticks = shape.ticks,
                    .robots = static_cast<std::size_t>(shape.robots),
                    .fingerprints = shape.ticks,
                    .checkpoints = shape.ticks / replay::checkpoint_ticks + 1};
  return std::min(max_plain_bytes,
                  most.plain_size() + both_teams.size() * shape.ticks * most.asked_size());
}

// The decompressed bytes behind the magic word; "" if they are damaged or more than `largest`.
std::string decompressed(std::string_view bytes, std::size_t largest) {
  const unsigned long long size = ZSTD_getFrameContentSize(bytes.data(), bytes.size());
  if (size == ZSTD_CONTENTSIZE_ERROR || size == ZSTD_CONTENTSIZE_UNKNOWN || size < head_size ||
      size > largest) {
    return "";
  }
  // One frame: a second one has no room in `plain`.
  std::string plain(size, '\0');
  if (ZSTD_decompress(plain.data(), plain.size(), bytes.data(), bytes.size()) != size) return "";
  return plain;
}

}  // namespace

std::string plain_replay(const replay::Recording& recording, int robots) {
  assert(robots > 0 && robots <= max_robots_per_team);
  const std::vector<match::TickLog>& ticks = recording.ticks;
  const replay::StateTrace& trace = recording.trace;
  const Counts counts{.ticks = ticks.size(),
                      .robots = static_cast<std::size_t>(robots),
                      .fingerprints = trace.ticks.size(),
                      .checkpoints = trace.checkpoints.size()};
  std::string plain;
  plain.reserve(counts.plain_size());
  for (const std::size_t count :
       {counts.ticks, counts.robots, counts.fingerprints, counts.checkpoints}) {
    put(plain, count, 4);
  }
  put_commands(plain, ticks, robots);
  for (const match::TickLog& tick : ticks) put(plain, tick.hash, 8);
  for (std::size_t body = 0; body < counts.bodies(); ++body) {
    for (const replay::Fingerprints& tick : trace.ticks) put(plain, tick[body], 1);
  }
  for (const replay::Checkpoint& checkpoint : trace.checkpoints) {
    for_each_number(checkpoint, counts.robots, [&plain](double number) {
      put(plain, std::bit_cast<std::uint64_t>(number), 8);
    });
  }

  put_asked(plain, recording.placement_requests, counts.robots);
  return plain;
}

std::string pack_replay(const replay::Recording& recording, int robots) {
  const std::string plain = plain_replay(recording, robots);
  std::string packed(magic);
  packed.resize(magic.size() + ZSTD_compressBound(plain.size()));
  const std::size_t size = ZSTD_compress(packed.data() + magic.size(), packed.size() - magic.size(),
                                         plain.data(), plain.size(), compression_level);
  packed.resize(magic.size() + size);
  return packed;
}

Result<Replay> unpack_replay(std::string_view bytes, const ReplayShape& shape,
                             const std::string& path) {
  const auto damaged = [&path](const char* why) { return fail(Errc::damaged, path + ": " + why); };
  if (bytes.substr(0, magic.size()) != magic) return damaged("this is not a replay of version 2");
  bytes.remove_prefix(magic.size());
  if (shape.ticks > max_ticks ||
      shape.ticks > always_allowed_ticks + bytes.size() / min_bytes_per_tick) {
    return damaged("it is too short for the ticks of the record");
  }
  const std::string plain = decompressed(bytes, largest_size(shape));
  if (plain.empty()) return damaged("the compressed data is damaged");
  return read_plain_replay(plain, shape, path);
}

Result<Replay> read_plain_replay(const std::string& plain, const ReplayShape& shape,
                                 const std::string& path) {
  const auto damaged = [&path](const char* why) { return fail(Errc::damaged, path + ": " + why); };
  if (plain.size() < head_size) return damaged("its length does not fit its ticks");
  Counts counts;
  std::size_t at = 0;
  for (std::size_t* count :
       {&counts.ticks, &counts.robots, &counts.fingerprints, &counts.checkpoints}) {
    *count = get(plain, at, 4);
  }
  if (counts.robots != static_cast<std::size_t>(shape.robots)) {
    return damaged("it has another number of robots than the record");
  }
  if (counts.ticks != shape.ticks) {
    return damaged("it has another number of ticks than the record says");
  }
  const bool is_whole = plain.size() >= counts.plain_size() &&
                        (plain.size() - counts.plain_size()) % counts.asked_size() == 0;
  if (!is_whole) return damaged("its length does not fit its ticks");
  if (counts.fingerprints != 0 && counts.fingerprints != counts.ticks) {
    return damaged("its trace does not fit its ticks");
  }

  Replay replay;
  replay.ticks.resize(counts.ticks);
  get_commands(plain, at, replay.ticks, shape.robots);
  for (match::TickLog& tick : replay.ticks) tick.hash = get(plain, at, 8);
  replay.trace.ticks.resize(counts.fingerprints);
  for (std::size_t body = 0; body < counts.bodies(); ++body) {
    for (replay::Fingerprints& tick : replay.trace.ticks) {
      tick[body] = static_cast<std::uint8_t>(get(plain, at, 1));
    }
  }
  replay.trace.checkpoints.resize(counts.checkpoints);
  for (replay::Checkpoint& checkpoint : replay.trace.checkpoints) {
    for_each_number(checkpoint, counts.robots,
                    [&](double& number) { number = std::bit_cast<double>(get(plain, at, 8)); });
  }
  replay.asked.resize((plain.size() - counts.plain_size()) / counts.asked_size());
  if (!get_asked(plain, at, replay.asked, counts.robots)) {
    return damaged("it has a placement in a tick without a restart");
  }
  return replay;
}

}  // namespace mirocup::record
