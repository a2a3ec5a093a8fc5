// SPDX-License-Identifier: MIT
//
// The program that plays a league. The journal names it, and programs/ in the folder of the league
// keeps a copy of its match server. So after an upgrade the program that played old records
// verifies them, and no league continues with another program by accident.
#pragma once

#include "record/match_record.hpp"
#include "tournaments/league/league_store.hpp"

#include <string>
#include <vector>

namespace mirocup::league {

// Refuses to play a league that another program has begun to play. With `accepts_other` it instead
// writes a line that this program continues the league. A program is another one if its version or
// its behaviour hash (`game`) differs. The hash is that of the journal or, if the journal has none,
// of the last record. Errors: Errc::input.
Result<void> expect_program(system::Files& files, LeagueStore& store,
                            const record::Software& program, bool accepts_other);

// If the league has no trusted copies of this match server and of the plugin host that it needs for
// a rerun, keeps copies with the league. Puts the match server on this host's list
// (league/kept_program.hpp). If the list cannot be written, standard error says so.
Result<void> keep_program(system::Files& files, const Folder& folder,
                          const record::Software& program);

// The result of verifying the records of a league.
struct VerifiedRecords {
  struct Problem {
    std::string record;  // its path inside the league
    std::string text;    // a sentence
    int code = 1;        // exit code: 1 not reproduced, 4 damaged or missing, ...
  };
  int records = 0;
  int reproduced = 0;
  std::vector<std::string> programs;  // "mirocup 0.1.0 (game 1234): 56 records, verified by PATH"
  std::vector<Problem> problems;
};

// Verifies all records of a league, `jobs` at once (0: one for each processor): the program that
// played a record simulates it again, and a record must be the one that the journal names. If the
// text of a record is damaged, no program is started. Errors: Errc::interrupted, or the reason why
// the verification cannot start.
Result<VerifiedRecords> verify_records(system::Files& files, const LeagueStore& store, int jobs);

}  // namespace mirocup::league
