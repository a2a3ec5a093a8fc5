// SPDX-License-Identifier: MIT
//
// The journal of a league: an append-only file from which tables and pages are derived.
//
// Each line is a JSON object with its number, the SHA-256 of the line before, and the SHA-256 of
// its own content. A line is on disk (fsync) before it has any effect. An incomplete last line,
// left by a process that died while writing, is ignored by readers and removed by the next
// append(). Any other damage is an error that names the line. A second file, the head, has number
// and hash of the last line, because the chain of hashes does not show that lines at the end are
// gone. format.md describes both files; league/event.hpp decodes the lines.
//
// Processes: any number may read a journal at any time. A process may append to the journal if it
// holds a FileLock while it calls refresh() and append(). Threads: one at a time.
#pragma once

#include "system/files.hpp"

#include <nlohmann/json_fwd.hpp>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace mirocup::league {

using Json = nlohmann::ordered_json;

// The remedy for a journal that is damaged or has lost lines: the end of a sentence.
inline constexpr const char* restore_journal =
    "; put back journal.jsonl and journal.head from the last copy that league backup made: legs "
    "that were played since are booked again from records/";

class Journal {
 public:
  // The most JSON values that all lines together may have: they stay in memory. The limit is enough
  // for a million legs.
  static constexpr std::size_t max_values = 20'000'000;

  // Reads the file; a missing file is an empty journal. `notice` gets a sentence for the user if an
  // incomplete last line was ignored. `head` is the path of the head; "": the journal has none.
  // `files` must outlive the journal.
  static Result<Journal> open(system::Files& files, std::string path, std::string* notice = nullptr,
                              std::size_t most_values = max_values, std::string head = "");
  Journal(Journal&&) noexcept;
  Journal& operator=(Journal&&) noexcept;
  ~Journal();

  const std::vector<Json>& lines() const { return lines_; }
  const std::string& path() const { return path_; }

  // Returns how many lines the head knows: all, or fewer if the writer died before it wrote the
  // head, or 0 if no head is there. Error: Errc::damaged if the journal lacks a line that the head
  // knows, or if the head is damaged.
  Result<std::size_t> known_lines() const;

  // Reads the lines that other processes have written since the last call.
  Result<void> refresh();

  // Writes a line: "n", "kind", the fields, "prev" and "hash", and then the head, which is never
  // behind by more than this line. After an error the journal is unchanged. A line that readers
  // would refuse, or that would follow on a lost line, is an error and is not written.
  Result<void> append(const std::string& kind, Json fields);

 private:
  Journal(system::Files& files, std::string path, std::size_t most_values, std::string head);

  Result<void> write_head();
  Result<void> read_line(std::string_view line);
  // Counts the values of a line. Returns an error if the journal then has more than most_values_.
  Result<void> add_values(std::size_t more, const std::string& where);

  system::Files* files_;
  std::string path_;
  std::vector<Json> lines_;
  std::string last_hash_;
  std::size_t size_ = 0;    // size of the whole lines, bytes
  std::size_t values_ = 0;  // number of JSON values of all lines
  std::size_t most_values_;
  std::string head_path_;                    // "": there is no head
  Result<std::optional<std::string>> head_;  // text of the head, as old as the lines or older
  bool is_torn_ = false;                     // true: an incomplete line follows the whole lines
};

}  // namespace mirocup::league
