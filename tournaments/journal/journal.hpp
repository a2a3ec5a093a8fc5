// SPDX-License-Identifier: MIT
//
// The journal of a league: an append-only file of all its events, from which tables and pages are
// computed.
//
// Each line is a JSON object with its number, the SHA-256 of the line before and its own. append()
// returns after the line is on disk. A torn last line, which a crash during a write leaves, is
// ignored by readers and removed by the next append(); any other damage is an error that names the
// line. format.md describes the lines.
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
  // Reads the file; an absent file is an empty journal. `notice` is set to a sentence for a person
  // if a torn line was ignored. The journal keeps a reference to `files`.
  static Result<Journal> open(system::Files& files, std::string path,
                              std::string* notice = nullptr);
  Journal(Journal&&) noexcept;
  Journal& operator=(Journal&&) noexcept;
  ~Journal();

  const std::vector<Json>& lines() const { return lines_; }
  const std::string& path() const { return path_; }

  // Reads the lines that other processes have appended since.
  Result<void> refresh();

  // Writes a line of this kind with these fields, "n", "prev" and "hash", and adds it to lines().
  // On an error the journal is unchanged.
  Result<void> append(const std::string& kind, Json fields);

 private:
  Journal(system::Files& files, std::string path);

  Result<void> read_line(const std::string& line);

  system::Files* files_;
  std::string path_;
  std::vector<Json> lines_;
  std::string last_hash_;
  std::size_t size_ = 0;  // bytes of whole lines
  bool is_torn_ = false;  // true: the file has bytes after them
};

}  // namespace mirocup::league
