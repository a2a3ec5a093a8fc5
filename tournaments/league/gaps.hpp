// SPDX-License-Identifier: MIT
//
// Compares the journal of a league with the files beside it. The files are witnesses: a night or a
// record without a line in the journal shows that the journal has lost lines, and a name in the
// journal without a file that a file is lost.
#pragma once

#include "tournaments/league/league_store.hpp"

#include <string>
#include <vector>

namespace mirocup::league {

struct Gaps {
  std::string lost;  // why lines of the journal are lost, with a remedy; "": none are
  // Records and nights without a line in the journal: paths inside the league. If no lines are
  // lost, the next start of the league enters these records into the journal.
  std::vector<std::string> not_booked;
  // Files that the journal names, and that are missing or no regular files.
  std::vector<std::string> missing;

  // True if the journal has its lines, and the files that it names are there.
  bool is_whole() const { return lost.empty() && missing.empty(); }

  // Returns sentences for a person, each with a remedy.
  std::vector<std::string> in_words() const;
};

// Returns the first of some names and the number of the others, for a sentence.
std::string listed(std::vector<std::string> names);

// True if a process plays the league, also if this computer does not know the process.
bool is_being_played(const Folder& folder);

// Returns the gaps. If another process plays the league, files may be younger than the state of the
// store, so `lost` follows from the journal's head alone, and `not_booked` is empty. Errors are
// those of reading the names of the records.
Result<Gaps> gaps(system::Files& files, const LeagueStore& store, bool is_being_played);

// Returns the records with their replay files, and the libraries of the entries, that the league
// needs: paths inside the league.
std::vector<std::string> named_files(const LeagueState& state);

}  // namespace mirocup::league
