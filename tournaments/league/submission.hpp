// SPDX-License-Identifier: MIT
//
// Handing in an entry: it is stored, checked as by `mirocup check`, and plays if it passes. If it
// fails, the team plays on with its last entry that passed.
#pragma once

#include "tournaments/league/league_store.hpp"

#include <nlohmann/json.hpp>

namespace mirocup::league {

struct Submission {
  bool is_accepted = false;
  int entry = 0;        // its number; 0: it was refused without a check
  std::string message;  // a sentence for the team
  Json verdict;         // result of the check, as in verdict.json; null without a check
};

// Hands in the library at `path` as an entry of the team. `now` is the time, as in
// LeagueFile::freeze. Until the league starts, a team that is not in it joins with its first entry
// that passes. An error is a failure of the host; an entry that is refused is a Submission, not an
// error.
Result<Submission> submit(system::Files& files, const Folder& folder, const std::string& team,
                          const std::string& path, const std::string& now);

}  // namespace mirocup::league
