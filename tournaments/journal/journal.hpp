// SPDX-License-Identifier: MIT
//
// What happened in a league: the only truth, append-only; tables and pages are made from it.
//
// One JSON object per line, numbered, each with the SHA-256 of the line before and of itself. A line
// is on disk before anybody acts on it. A last line that was cut off while it was written is left
// out when reading and cut off when writing; any other damage is an error that names the line.
// format.md has the lines.
//
// Several processes may read a journal at any time, and write to it if each holds a FileLock while
// it calls refresh() and append().
#pragma once

#include "server/system/files.hpp"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace mirocup::league {

using Json = nlohmann::ordered_json;

class Journal {
 public:
  // Reads what is there; an absent file is an empty journal. `notice` is set if a torn line was left
  // out.
  static Result<Journal> open(system::Files& files, std::string path,
                              std::string* notice = nullptr);
  Journal(Journal&&) noexcept;
  Journal& operator=(Journal&&) noexcept;
  ~Journal();

  const std::vector<Json>& lines() const { return lines_; }
  const std::string& path() const { return path_; }

  // Reads the lines that others have written since.
  Result<void> refresh();

  // Adds "n", "prev" and "hash" to the line and writes it. On an error the journal is as before.
  Result<void> append(const std::string& kind, Json fields);

 private:
  Journal(system::Files& files, std::string path);

  Result<void> read_line(const std::string& line);

  system::Files* files_;
  std::string path_;
  std::vector<Json> lines_;
  std::string last_hash_;
  std::size_t size_ = 0;  // bytes of whole lines
  bool is_torn_ = false;  // are there bytes after them?
};

}  // namespace mirocup::league
