// SPDX-License-Identifier: MIT
//
// Handing in an entry: the library is stored and checked as by `mirocup check`. It plays if it
// passes; otherwise the team goes on with its last entry that passed.
#pragma once

#include "tournaments/league/league_store.hpp"

#include <nlohmann/json.hpp>

namespace mirocup::league {

struct Submission {
  bool is_accepted = false;
  int entry = 0;        // its number; 0: it was not even stored
  std::string message;  // a sentence for the team
  Json verdict;         // of the check, as in verdict.json; null if there was no check
};

// Hands in the library at `path` for a team. `now` is the time, written as LeagueFile::freeze. A
// team that is not in league.json joins with its first accepted entry, until the league starts. An
// entry that fails its check is a value; errors are faults of the host or of the call.
Result<Submission> submit(system::Files& files, const Folder& folder, const std::string& team,
                          const std::string& path, const std::string& now);

}  // namespace mirocup::league
