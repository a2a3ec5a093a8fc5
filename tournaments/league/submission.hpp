// SPDX-License-Identifier: MIT
//
// Handing in an entry: the library is stored and checked as by `mirocup check`. It plays if it
// passes; otherwise the team goes on with its last entry that passed.
//
// The file is opened once and read into memory, before any lock is taken. What is checked, hashed
// and kept are these bytes.
#pragma once

#include "tournaments/league/hand_ins.hpp"
#include "tournaments/league/league_store.hpp"

#include <nlohmann/json.hpp>

namespace mirocup::league {

// A file that is handed in.
struct HandIn {
  std::string team;
  std::string path;
  std::int64_t at = 0;  // s since 1970

  // True: an inbox is read again and again, so a file that equals the team's last entry is no news.
  bool is_from_inbox = false;

  // The number under which the file is stored already, as the library of that entry, since it
  // waited for its check; 0: it gets the next number when it is looked at.
  int entry = 0;
  // A source that waited: the library is made from it first. "": `path` is the library.
  std::string source = {};
  std::string language = {};  // of the source: "c", "c++", or "project", which is an archive
  int compile_seconds = 60;   // of processor time, that compiling it may take
  std::string name = {};      // what its team calls the file, for its verdict; "": the path
  bool is_house = false;      // the host hands in the house team `name`, "house:NAME"

  // In an inbox that several users can write to, the users whose files are the host's own word.
  // Files of others count for the teams of their owners only, and a file with a second name (hard
  // link) is refused. Empty: every file is the host's own word.
  std::vector<uid_t> trusted;
};

struct Submission {
  bool is_news = true;  // false: it was handed in before, and nothing was done
  bool is_accepted = false;
  int entry = 0;        // its number; 0: it was not even stored
  std::string message;  // a sentence for the team
  Json verdict;         // of the check, as in verdict.json; null if there was no check
};

// Returns why no entry of this team is taken at this time (UTC, as league.json has it); "" if
// entries are taken. A team that the league does not know may join before the start.
std::string why_not_now(const LeagueState& state, const std::string& team, const std::string& now);

// Returns why no team of this name can join the league, whatever it hands in; "" if it can.
std::string why_not_join(const LeagueState& state, const std::string& team);

// Makes teams: before the start in league.json, after it in the journal. `source` is
// TeamConfig::source. The caller holds Folder::submitting(). Precondition: why_not_join() is "".
Result<void> enter_teams(system::Files& files, LeagueStore& store,
                         const std::vector<std::string>& teams, const std::string& source);

// Takes a team out of league.json. Precondition: the league has not started, and has the team.
Result<void> leave_before_start(system::Files& files, LeagueStore& store, const std::string& team);

// Lets an entry play until another is pinned; 0: again the latest accepted one. In a ladder that
// has started it is booked at once. Returns why that cannot be, a sentence; "" if it is done.
Result<std::string> pin_entry(system::Files& files, const Folder& folder, const std::string& team,
                              int number, std::int64_t now);

// Hands in a library for a team. A team that is not in league.json joins with its first accepted
// entry, until the league starts; its name must differ from the others' by more than capitals. What
// is wrong with the file, and a quota that is used up, is a value; errors are faults of the host or
// of the call.
//
// The result is fixed when entry.json is on disk. A process that dies before that has done nothing;
// one that dies later has left it to the next call with the same number, which checks nothing again
// and finishes what is missing.
Result<Submission> submit(system::Files& files, const Folder& folder, const HandIn& handed,
                          const Quota& quota = {});

}  // namespace mirocup::league
