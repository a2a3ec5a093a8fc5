// SPDX-License-Identifier: MIT
//
// The entries of teams as the API and the pages show them.
//
// Threads: all functions may be called by any thread at any time.
#pragma once

#include "tournaments/handin/desk_state.hpp"
#include "web/http/request.hpp"

namespace mirocup::league {

// The path of the page of an entry, without the entry's number at its end.
constexpr std::string_view entry_pages_path = "/hand-in/entries/";

// The most entries that a list has.
constexpr std::size_t listed_entries = 100;

class Entries {
 public:
  explicit Entries(DeskState& state) : state_(state) {}

  // Returns the report of an entry; null if the team has no entry of this number. `is_whole`: the
  // report has the log and all figures, as on the entry's own page.
  Result<Json> report(const std::string& team, int entry, bool is_whole);

  // Returns {"team", "entries", "older"}: the summaries of the team's latest entries with numbers
  // below `before`, the latest first, and the `before` of the next list; null if none follows.
  Result<Json> reports(const std::string& team, int before);

  // Returns a stream of the states of an entry. It ends when the entry's check has an answer.
  web::Reply events(const std::string& team, int entry);

 private:
  DeskState& state_;
};

}  // namespace mirocup::league
