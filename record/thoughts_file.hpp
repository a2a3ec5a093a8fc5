// SPDX-License-Identifier: MIT
//
// The file with the shapes that a team drew in a leg (mirocup/thoughts/1 of schema.md): JSON lines,
// one for each shape, packed with zstd. The file lies beside the record, and no other file depends
// on it.
#pragma once

#include "core/base/error.hpp"
#include "core/field/team.hpp"
#include "core/match/snapshot.hpp"
#include "core/match/thought.hpp"
#include "record/thought_line.hpp"
#include "system/files.hpp"

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

struct ZSTD_CCtx_s;

namespace mirocup::record {

// Returns the path of a team's thoughts: NAME.blue.thoughts.zst beside NAME.json.
std::string thoughts_path(const std::string& record_path, Team team);

// Collects the thoughts of one team in a leg. The writer packs thoughts while they come, so that a
// leg needs no memory for all thoughts.
class ThoughtsWriter {
 public:
  // Adds a shape of a tick. Drops the first shape with which the leg would exceed
  // max_thought_bytes, and all shapes after it.
  void add(std::uint32_t tick, const match::Thought& thought);

  // Counts shapes that were dropped before they came to this writer.
  void count_left_out(std::uint32_t shapes) { left_out_ += shapes; }

  // Returns how many shapes of the leg were dropped so far.
  std::uint64_t left_out() const { return left_out_; }

  // Ends the file and returns its bytes. If shapes were dropped, the last line says how many. After
  // this call nothing can be added.
  std::string packed();

 private:
  struct Free {
    void operator()(ZSTD_CCtx_s* packer) const;
  };

  void pack(bool is_end);

  ThoughtLine line_;
  std::string lines_;     // lines that are not packed yet
  std::size_t size_ = 0;  // bytes of all lines
  std::string packed_;
  std::unique_ptr<ZSTD_CCtx_s, Free> packer_;  // null before the first lines are packed
  std::uint32_t last_tick_ = 0;
  std::uint64_t left_out_ = 0;
  bool is_full_ = false;
};

// Returns the JSON lines of a file. The error names `path` and says why the bytes are not a file of
// thoughts.
Result<std::string> unpacked_thoughts(std::string_view bytes, const std::string& path);

// What only a team and its host may see of a leg. For an empty text a page shows nothing.
struct OwnTexts {
  match::ByTeam<std::string> thoughts;  // JSON lines of mirocup/thoughts/1
  match::ByTeam<std::string> logs;      // output of the teams
};

// The teams whose thoughts and logs a reader may see.
using Whose = match::ByTeam<bool>;
inline constexpr Whose of_nobody{false, false};
inline constexpr Whose of_both{true, true};

// Returns true if thoughts of at least one of these teams were kept with the record.
bool has_thoughts(system::Files& files, const std::string& record_path, const Whose& whose);

// Reads the thoughts and logs of these teams in the leg. Texts whose files are missing are empty.
// Errors are those of Files::read() and of unpacked_thoughts().
Result<OwnTexts> read_own_texts(system::Files& files, const std::string& record_path,
                                const Whose& whose, system::Links links = system::Links::refused);

}  // namespace mirocup::record
