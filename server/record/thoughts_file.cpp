// SPDX-License-Identifier: MIT
#include "server/record/thoughts_file.hpp"

#include "system/printable.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
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

constexpr double units_per_metre = 1e4;  // 0.1 mm
constexpr double furthest = 1e3;         // m; what is further away is no part of a picture

template <class Number>
void append_whole(std::string& line, Number number) {
  char digits[24];
  line.append(digits, std::to_chars(digits, digits + sizeof digits, number).ptr);
}

void append_metres(std::string& line, double metres) {
  const double bounded = std::clamp(metres, -furthest, furthest);
  auto units = static_cast<std::int64_t>(std::lround(bounded * units_per_metre));
  if (units < 0) {
    line += '-';
    units = -units;
  }
  constexpr auto scale = static_cast<std::int64_t>(units_per_metre);
  append_whole(line, units / scale);
  auto rest = static_cast<std::uint32_t>(units % scale);
  if (rest == 0) return;
  char text[5]{'.'};
  std::size_t length = 1;
  for (std::uint32_t digit = scale / 10; rest > 0; digit /= 10) {
    text[length++] = static_cast<char>('0' + rest / digit);
    rest %= digit;
  }
  line.append(text, length);
}

// Appends #RRGGBBAA.
void append_colour(std::string& line, std::uint32_t colour) {
  constexpr std::string_view digits = "0123456789abcdef";
  char text[9]{'#'};
  for (std::size_t i = 8; i > 0; --i, colour >>= 4) text[i] = digits[colour & 15u];
  line.append(text, sizeof text);
}

bool is_plain(char c) {
  return c >= ' ' && c <= '~' && c != '"' && c != '\\';
}

// Appends foreign text as a JSON string.
void append_text(std::string& line, std::string_view text) {
  line += '"';
  if (std::all_of(text.begin(), text.end(), is_plain)) {
    line += text;
  } else {
    for (const char c : system::printable(text)) {
      if (c == '"' || c == '\\') line += '\\';
      line += c == '\t' ? ' ' : c;
    }
  }
  line += '"';
}

void append_numbers(std::string& line, std::span<const double> numbers) {
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (i > 0) line += ',';
    append_metres(line, numbers[i]);
  }
}

void append_corners(std::string& line, std::span<const double> numbers) {
  for (std::size_t i = 0; i + 1 < numbers.size(); i += 2) {
    line += i > 0 ? ",[" : "[";
    append_numbers(line, numbers.subspan(i, 2));
    line += ']';
  }
}

}  // namespace

std::string thoughts_path(const std::string& record_path, Team team) {
  const std::string ending = "." + std::string(to_string(team)) + ".thoughts.zst";
  return std::filesystem::path(record_path).replace_extension().string() + ending;
}

void ThoughtsWriter::add(std::uint32_t tick, const match::Thought& thought) {
  const std::size_t before = lines_.size();
  last_tick_ = tick;
  lines_ += "{\"tick\":";
  append_whole(lines_, tick);
  lines_ += ",\"layer\":";
  append_text(lines_, thought.layer);
  lines_ += ",\"colour\":\"";
  append_colour(lines_, thought.colour);
  lines_ += "\",\"";
  lines_ += to_string(thought.kind);
  lines_ += "\":[";
  if (thought.kind == match::ThoughtKind::polygon) {
    append_corners(lines_, thought.numbers);
  } else {
    append_numbers(lines_, thought.numbers);
  }
  if (thought.kind == match::ThoughtKind::text) {
    lines_ += ',';
    append_text(lines_, thought.text);
  }
  lines_ += "]}\n";
  const std::size_t added = lines_.size() - before;
  if (size_ + added > match::max_thought_bytes) {
    lines_.resize(before);
    ++left_out_;
    return;
  }
  size_ += added;
  if (lines_.size() >= packed_at_once) pack(false);
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

// Unpacks a file that says how long its text is, as those of earlier versions do.
bool unpack_at_once(std::string_view bytes, std::string& lines) {
  const std::size_t got = ZSTD_decompress(lines.data(), lines.size(), bytes.data(), bytes.size());
  return !ZSTD_isError(got) && got == lines.size();
}

// Returns false if the bytes are damaged, are too many or end too early or too late.
bool unpack_in_parts(std::string_view bytes, std::string& lines) {
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
  const unsigned long long size = ZSTD_getFrameContentSize(bytes.data(), bytes.size());
  const bool is_known = size != ZSTD_CONTENTSIZE_UNKNOWN;
  if (size == ZSTD_CONTENTSIZE_ERROR || (is_known && size > most_unpacked)) {
    return fail(Errc::damaged, path + ": these are no thoughts of a leg");
  }
  std::string lines(is_known ? size : 0, '\0');
  if (!(is_known ? unpack_at_once(bytes, lines) : unpack_in_parts(bytes, lines)))
    return fail(Errc::damaged, path + ": the thoughts are damaged");
  return lines;
}

}  // namespace mirocup::record
