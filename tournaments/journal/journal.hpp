// SPDX-License-Identifier: MIT
//
// What happened in a league: the only truth, append-only; tables and pages are made from it.
//
// One JSON object per line, numbered, each with the SHA-256 of the line before. A line is on disk
// before anybody acts on it. Loading heals a last line that was cut off while it was written; any
// other damage is an error that names the line. format.md has the lines.
#pragma once

#include "server/record/files.hpp"

#include <nlohmann/json.hpp>

#include <optional>
#include <string>
#include <vector>

namespace mirocup::league {

using Json = nlohmann::ordered_json;

class Journal {
 public:
  // Reads what is there; an absent file is an empty journal. `notice` is set if a torn line was cut
  // off.
  static Result<Journal> open(record::Files& files, std::string path,
                              std::string* notice = nullptr);

  const std::vector<Json>& lines() const { return lines_; }

  // Adds "n" and "prev" to the line and writes it. On an error the journal is as before.
  Result<void> append(const std::string& kind, Json fields);

 private:
  Journal(record::Files& files, std::string path) : files_(&files), path_(std::move(path)) {}

  record::Files* files_;
  std::string path_;
  std::vector<Json> lines_;
  std::string last_hash_;
};

}  // namespace mirocup::league
