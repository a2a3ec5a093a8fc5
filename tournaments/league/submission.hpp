// SPDX-License-Identifier: MIT
//
// Handing in an entry: it is kept, checked as `mirocup check` does, and plays if it passes. Who had
// one that passed before plays on with that if it does not.
#pragma once

#include "tournaments/league/league_store.hpp"

#include <nlohmann/json.hpp>

namespace mirocup::league {

struct Submission {
  bool is_accepted = false;
  int entry = 0;        // its number; 0: it was not taken at all
  std::string message;  // a sentence for the team
  Json verdict;         // of the check, as in verdict.json; null if there was none
};

// `now` as in LeagueFile::freeze. A team that the league does not know yet joins it with its first
// good entry, until the league starts. Errors are the host's; a bad entry is none.
Result<Submission> submit(system::Files& files, const Folder& folder, const std::string& team,
                          const std::string& path, const std::string& now);

}  // namespace mirocup::league
