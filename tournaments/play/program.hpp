// SPDX-License-Identifier: MIT
//
// The program that plays a league. The journal names this program, so that no league continues with
// another program by accident.
#pragma once

#include "record/match_record.hpp"
#include "tournaments/league/league_store.hpp"

#include <string>
#include <vector>

namespace mirocup::league {

// Refuses to play a league that another program has begun to play: a program of another minor
// version (0.2 after 0.1), or with another behaviour hash (`game`). Errors: Errc::input.
Result<void> expect_program(const LeagueStore& store, const record::Software& program);

// The result of verifying the records of a league.
struct VerifiedRecords {
  struct Problem {
    std::string record;  // path inside the league: of a record, a night or the journal
    std::string text;    // a sentence about the result
    int code = 1;        // exit code: 1 not reproduced, 4 damaged or missing, ...
  };
  int records = 0;
  int reproduced = 0;
  std::vector<Problem> problems;
};

// Verifies all records of a league, `jobs` at once (0: one for each processor), each as
// `mirocup verify` does. The record must be the record that the journal names,
// and the journal must have the lines of all records and nights. If the text of a record is
// damaged, its leg is not simulated. Errors: Errc::interrupted, or the reason why the verification
// cannot start.
Result<VerifiedRecords> verify_records(system::Files& files, const LeagueStore& store, int jobs);

// Verifies only the records at `paths` inside the league, and does not ask the journal.
Result<VerifiedRecords> verify_records(system::Files& files, const Folder& folder,
                                       const std::vector<std::string>& paths, int jobs);

}  // namespace mirocup::league
