// SPDX-License-Identifier: MIT
#include "record/replay_file.hpp"

#include <algorithm>
#include <bit>
#include <cassert>
#include <concepts>
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

// Writes the numbers of a replay, little-endian. A Reader has the same functions.
class Writer {
 public:
  explicit Writer(std::string& bytes) : bytes_(bytes) {}

  void integer(std::uint64_t value, int width) {
    for (int i = 0; i < width; ++i) bytes_ += static_cast<char>(value >> (8 * i));
  }
  void numbers(std::same_as<double> auto... values) {
    (integer(std::bit_cast<std::uint64_t>(values), 8), ...);
  }
  void team(Team team) { integer(static_cast<std::uint64_t>(index_of(team)), 1); }
  // The difference of a command from that of the tick before.
  void command(std::int16_t value, std::uint16_t& before) {
    const auto now = static_cast<std::uint16_t>(value);
    integer(static_cast<std::uint16_t>(now - before), 2);
    before = now;
  }

 private:
  std::string& bytes_;
};

class Reader {
 public:
  // The caller has seen that there are as many bytes as will be read.
  explicit Reader(const std::string& bytes) : bytes_(bytes) {}

  void integer(auto& value, int width) {
    std::uint64_t read = 0;
    for (int i = 0; i < width; ++i)
      read |= static_cast<std::uint64_t>(static_cast<unsigned char>(bytes_[at_++])) << (8 * i);
    value = static_cast<std::decay_t<decltype(value)>>(read);
  }
  void numbers(std::same_as<double> auto&... values) {
    std::uint64_t bits = 0;
    ((integer(bits, 8), values = std::bit_cast<double>(bits)), ...);
  }
  void team(Team& team) {
    std::uint8_t index = 0;
    integer(index, 1);
    has_wrong_team_ = has_wrong_team_ || index >= both_teams.size();
    team = both_teams[index % both_teams.size()];
  }
  void command(std::int16_t& value, std::uint16_t& before) {
    std::uint16_t difference = 0;
    integer(difference, 2);
    before = static_cast<std::uint16_t>(before + difference);
    value = static_cast<std::int16_t>(before);
  }

  bool has_wrong_team() const { return has_wrong_team_; }

 private:
  const std::string& bytes_;
  std::size_t at_ = 0;
  bool has_wrong_team_ = false;
};

// Column by column, each as differences: commands change little from tick to tick.
void transfer_commands(auto& stream, auto& ticks, std::size_t robots) {
  for (int team = 0; team < 2; ++team) {
    for (std::size_t i = 0; i < robots; ++i) {
      for (int wheel = 0; wheel < 2; ++wheel) {
        std::uint16_t before = 0;
        for (auto& tick : ticks) stream.command(tick.commands[team].wheels[i][wheel], before);
      }
    }
  }
}

void transfer_checkpoint(auto& stream, auto& checkpoint, std::size_t robots) {
  for (std::size_t i = 0; i < 2 * robots; ++i) {
    auto& robot = checkpoint.robots[i];
    stream.numbers(robot.position.x(), robot.position.y(), robot.heading.cos, robot.heading.sin);
    stream.numbers(robot.twist.forward, robot.twist.left, robot.twist.omega);
  }
  auto& [position, velocity] = checkpoint.ball;
  stream.numbers(position.x(), position.y(), velocity.x(), velocity.y());
}

// The poses that a team asked for at a restart.
void transfer_asked(auto& stream, auto& asked, std::size_t robots) {
  stream.integer(asked.tick, 4);
  stream.team(asked.team);
  stream.numbers(asked.request.ball_x, asked.request.ball_y);
  for (std::size_t i = 0; i < robots; ++i) {
    auto& pose = asked.request.robots[i];
    stream.numbers(pose.x, pose.y, pose.heading);
  }
}

// Everything after the counts, in the order of the file.
void transfer(auto& stream, const Counts& counts, auto& ticks, auto& trace, auto& all_asked) {
  transfer_commands(stream, ticks, counts.robots);
  for (auto& tick : ticks) stream.integer(tick.hash, 8);
  for (std::size_t body = 0; body < counts.bodies(); ++body) {
    for (auto& tick : trace.ticks) stream.integer(tick[body], 1);
  }
  for (auto& checkpoint : trace.checkpoints) transfer_checkpoint(stream, checkpoint, counts.robots);
  for (auto& asked : all_asked) transfer_asked(stream, asked, counts.robots);
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
  Writer writer(plain);
  for (const std::size_t count :
       {counts.ticks, counts.robots, counts.fingerprints, counts.checkpoints}) {
    writer.integer(count, 4);
  }
  transfer(writer, counts, ticks, trace, recording.placement_requests);
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
  Reader reader(plain);
  for (std::size_t* count :
       {&counts.ticks, &counts.robots, &counts.fingerprints, &counts.checkpoints}) {
    reader.integer(*count, 4);
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
  replay.trace.ticks.resize(counts.fingerprints);
  replay.trace.checkpoints.resize(counts.checkpoints);
  replay.asked.resize((plain.size() - counts.plain_size()) / counts.asked_size());
  transfer(reader, counts, replay.ticks, replay.trace, replay.asked);
  const bool is_in_order =
      std::is_sorted(replay.asked.begin(), replay.asked.end(),
                     [](const auto& a, const auto& b) { return a.tick < b.tick; });
  if (reader.has_wrong_team() || !is_in_order)
    return damaged("it has a placement in a tick without a restart");
  return replay;
}

}  // namespace mirocup::record
