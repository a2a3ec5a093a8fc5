// SPDX-License-Identifier: MIT
//
// The program that plays a league. The journal names it, and programs/ in the folder of the league
// keeps a copy of its match server. So after an upgrade old records are verified by the program
// that played them, and no league goes on with another one by accident.
#pragma once

#include "record/match_record.hpp"
#include "tournaments/league/league_store.hpp"

#include <string>
#include <vector>

namespace mirocup::league {

// Refuses to play a league that another program has begun to play, unless `accepts_other`: then a
// line says that this one goes on. A program is another one if its version or the hash of its
// behaviour (`game`) is; where the journal does not name the latter, the last record does. Errors:
// Errc::input.
Result<void> expect_program(system::Files& files, LeagueStore& store,
                            const record::Software& program, bool accepts_other);

// Keeps copies of this match server, and of the host of teams' libraries that it needs for a rerun,
// with the league, if no trusted ones are there, and puts the match server on this host's list
// (league/kept_program.hpp). If the list cannot be written, standard error says so.
Result<void> keep_program(system::Files& files, const Folder& folder,
                          const record::Software& program);

// What became of the records of a league.
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

// Verifies all records of a league, `jobs` at once (0: one for each processor): each is simulated
// again by the program that played it, and those that the journal names are the ones that it means.
// For a record whose own text is damaged, no program is started.
// Errors: Errc::interrupted, or what keeps a verification from starting.
Result<VerifiedRecords> verify_records(system::Files& files, const LeagueStore& store, int jobs);

}  // namespace mirocup::league
