// SPDX-License-Identifier: MIT
//
// The file with the shapes that a team drew in a leg (mirocup/thoughts/1 of schema.md): JSON lines,
// one for each shape, packed with zstd. The file lies beside the record, and no other file depends
// on it.
#pragma once

#include "core/base/error.hpp"
#include "core/field/team.hpp"
#include "core/match/thought.hpp"
#include "record/thought_line.hpp"

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

}  // namespace mirocup::record
