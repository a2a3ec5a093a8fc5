// SPDX-License-Identifier: MIT
//
// Handing in an entry: the library is stored and checked as by `mirocup check`. An entry that
// passes the check plays; otherwise the team keeps its last entry that passed.
//
// The file is opened once and read into memory, before any lock is taken. The bytes in memory are
// checked, hashed and kept.
#pragma once

#include "tournaments/league/hand_ins.hpp"
#include "tournaments/league/league_store.hpp"

#include <nlohmann/json.hpp>

#include <functional>

namespace mirocup::league {

// A file that is handed in.
struct HandIn {
  std::string team;
  std::string path;
  std::int64_t at = 0;  // s since 1970

  // The entry's number if the file was stored earlier and waited for its check. 0: the file gets
  // the next number now.
  int entry = 0;
  // The path of a source that waited for its check; the library is made from it first. "": `path`
  // is the library.
  std::string source = {};
  std::string language = {};  // language of the source: "c", "c++", or "project" (an archive)
  int compile_seconds = 60;   // limit of processor time for compiling the source
  std::string name = {};      // name of the file in the verdict; "": `path`
  bool is_house = false;      // the host hands in the house team `name`, "house:NAME"
};

struct Submission {
  bool is_accepted = false;
  int entry = 0;        // the entry's number; 0: not stored
  int plays = 0;        // the entry that plays after a refusal; 0: none
  std::string message;  // a sentence for the team
  Json verdict;         // of the check, as in verdict.json; null if no check ran
};

// Returns why the league takes no entry of this team at this time (UTC, as in league.json); "" if
// the league takes it. An unknown team may join before the start.
std::string why_not_now(const LeagueState& state, const std::string& team, const std::string& now);

// Returns why no team of this name can join the league; "" if a team can.
std::string why_not_join(const LeagueState& state, const std::string& team);

// Adds teams to a league: before the start in league.json, after the start in the journal. `source`
// is TeamConfig::source. The caller holds Folder::submitting(). Precondition: why_not_join() is "".
Result<void> enter_teams(system::Files& files, LeagueStore& store,
                         const std::vector<std::string>& teams, const std::string& source);

// Takes a team out of league.json. Precondition: the league has not started, and has the team.
Result<void> leave_before_start(system::Files& files, LeagueStore& store, const std::string& team);

// Pins an entry, which plays until another entry is pinned. If `number` is 0, the latest accepted
// entry plays again. In a ladder that has started, the entry is booked at once. Returns a sentence
// that says why the entry cannot be pinned; "" if it was pinned. Calls `note` before it changes
// anything, and the team's file is written last: the same call again finishes a call that did not
// come to its end.
Result<std::string> pin_entry(system::Files& files, const Folder& folder, const std::string& team,
                              int number, std::int64_t now,
                              const std::function<Result<void>()>& note);

// Hands in a library for a team. Before the start of the league, a team that is not in league.json
// joins with its first accepted entry; its name must differ from those of other teams in more than
// capital letters. A mistake in the file and a used-up quota give a Submission that says so; errors
// are faults of the host or of the call.
//
// The result is fixed when entry.json is on disk. A process that dies before that moment has had no
// effect. If a process dies after it, the next call with the same number does not check again, and
// finishes the missing steps.
Result<Submission> submit(system::Files& files, const Folder& folder, const HandIn& handed,
                          const Quota& quota = {});

}  // namespace mirocup::league
