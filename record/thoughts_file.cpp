// SPDX-License-Identifier: MIT
#include "record/thoughts_file.hpp"

#include <algorithm>
#include <filesystem>
#include <memory>
#include <vector>
#include <zstd.h>

namespace mirocup::record {

namespace {

// The lines are alike, so the lowest level packs them to a tenth already.
constexpr int thoughts_level = 1;

constexpr int most_window = 23;  // as a power of 2; the lowest level needs 19

}  // namespace

std::string thoughts_path(const std::string& record_path, Team team) {
  const std::string ending = "." + std::string(to_string(team)) + ".thoughts.zst";
  return std::filesystem::path(record_path).replace_extension().string() + ending;
}

void ThoughtsWriter::add(std::uint32_t tick, const match::Thought& thought) {
  last_tick_ = tick;
  const std::string_view line = is_full_ ? std::string_view() : line_.write(tick, thought);
  is_full_ = is_full_ || lines_.size() + line.size() > match::max_thought_bytes;
  if (is_full_)
    ++left_out_;
  else
    lines_ += line;
}

std::string ThoughtsWriter::packed() {
  if (left_out_ > 0) {
    lines_ += "{\"tick\":" + std::to_string(last_tick_) +
              ",\"layer\":\"mirocup\",\"colour\":\"#808080ff\",\"text\":[0,0,\"" +
              std::to_string(left_out_) + " shapes of the leg were left out\"]}\n";
  }
  std::string packed(ZSTD_compressBound(lines_.size()), '\0');
  packed.resize(
      ZSTD_compress(packed.data(), packed.size(), lines_.data(), lines_.size(), thoughts_level));
  return packed;
}

namespace {

constexpr std::size_t most_unpacked = match::max_thought_bytes + 1024;  // with the last line

// Returns false if the bytes are damaged, are too many or end too early or too late.
bool unpack(std::string_view bytes, std::string& lines) {
  const std::unique_ptr<ZSTD_DCtx, std::size_t (*)(ZSTD_DCtx*)> unpacker(ZSTD_createDCtx(),
                                                                         ZSTD_freeDCtx);
  ZSTD_DCtx_setParameter(unpacker.get(), ZSTD_d_windowLogMax, most_window);
  ZSTD_inBuffer in{bytes.data(), bytes.size(), 0};
  std::vector<char> part(ZSTD_DStreamOutSize());
  while (true) {
    ZSTD_outBuffer out{part.data(), part.size(), 0};
    const std::size_t left = ZSTD_decompressStream(unpacker.get(), &out, &in);
    if (ZSTD_isError(left) || lines.size() + out.pos > most_unpacked) return false;
    lines.append(part.data(), out.pos);
    if (left == 0) return in.pos == in.size;
    if (in.pos == in.size && out.pos < out.size) return false;
  }
}

}  // namespace

Result<std::string> unpacked_thoughts(std::string_view bytes, const std::string& path) {
  std::string lines;
  if (!unpack(bytes, lines)) return fail(Errc::damaged, path + ": the thoughts are damaged");
  return lines;
}

bool has_thoughts(system::Files& files, const std::string& record_path, const Whose& whose) {
  return std::any_of(both_teams.begin(), both_teams.end(), [&](Team team) {
    return whose[index_of(team)] && files.exists(thoughts_path(record_path, team));
  });
}

Result<OwnTexts> read_own_texts(system::Files& files, const std::string& record_path,
                                const Whose& whose, system::Links links) {
  OwnTexts own;
  for (const Team team : both_teams) {
    if (!whose[index_of(team)]) continue;
    if (const std::string path = thoughts_path(record_path, team); files.exists(path)) {
      MIROCUP_TRY(const auto bytes,
                  files.read(path, {.max_size = system::size_limit::replay, .links = links}));
      MIROCUP_TRY(own.thoughts[index_of(team)], unpacked_thoughts(bytes, path));
    }
    const std::string path = record_path + "." + std::string(to_string(team)) + ".log";
    if (!files.exists(path)) continue;
    MIROCUP_TRY(own.logs[index_of(team)],
                files.read(path, {.max_size = system::size_limit::log, .links = links}));
  }
  return own;
}

}  // namespace mirocup::record
