// SPDX-License-Identifier: MIT
#include "record/thoughts_file.hpp"

#include <algorithm>
#include <filesystem>
#include <utility>
#include <vector>
#include <zstd.h>

namespace mirocup::record {

namespace {

// The lines are alike, so the lowest level packs them to a tenth already.
constexpr int thoughts_level = 1;

constexpr std::size_t packed_at_once = 64u << 10;  // bytes of lines; they stay in the cache
constexpr int most_window = 23;                    // as a power of 2; the lowest level needs 19

}  // namespace

std::string thoughts_path(const std::string& record_path, Team team) {
  const std::string ending = "." + std::string(to_string(team)) + ".thoughts.zst";
  return std::filesystem::path(record_path).replace_extension().string() + ending;
}

void ThoughtsWriter::add(std::uint32_t tick, const match::Thought& thought) {
  last_tick_ = tick;
  if (!is_full_) {
    const std::string_view line = line_.write(tick, thought);
    is_full_ = size_ + line.size() > match::max_thought_bytes;
    if (!is_full_) {
      size_ += line.size();
      lines_ += line;
      if (lines_.size() >= packed_at_once) pack(false);
      return;
    }
  }
  ++left_out_;
}

void ThoughtsWriter::Free::operator()(ZSTD_CCtx_s* packer) const {
  ZSTD_freeCCtx(packer);
}

void ThoughtsWriter::pack(bool is_end) {
  if (!packer_) {
    packer_.reset(ZSTD_createCCtx());
    ZSTD_CCtx_setParameter(packer_.get(), ZSTD_c_compressionLevel, thoughts_level);
  }
  const ZSTD_EndDirective how = is_end ? ZSTD_e_end : ZSTD_e_continue;
  ZSTD_inBuffer in{lines_.data(), lines_.size(), 0};
  char bytes[1 << 14];
  std::size_t left = 0;
  do {
    ZSTD_outBuffer out{bytes, sizeof bytes, 0};
    left = ZSTD_compressStream2(packer_.get(), &out, &in, how);
    packed_.append(bytes, out.pos);
  } while (!ZSTD_isError(left) && (is_end ? left > 0 : in.pos < in.size));
  lines_.clear();
}

std::string ThoughtsWriter::packed() {
  if (left_out_ > 0) {
    lines_ += "{\"tick\":" + std::to_string(last_tick_) +
              ",\"layer\":\"mirocup\",\"colour\":\"#808080ff\",\"text\":[0,0,\"" +
              std::to_string(left_out_) + " shapes of the leg were left out\"]}\n";
    left_out_ = 0;
  }
  pack(true);
  return std::move(packed_);
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
