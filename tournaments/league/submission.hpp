// SPDX-License-Identifier: MIT
//
// Handing in an entry: the file is stored and checked as by `mirocup check`. An entry that passes
// the check plays; otherwise the team keeps its last entry that passed.
//
// The order of all writes is: the file, and the line of the book that it was handed in;
// verdict.json by the check; the line of the answer, and then what follows from it: the team joins,
// entry.json, and the line of the league's journal. The next process does what one that was killed
// has left undone: follow_book().
#pragma once

#include "system/file_lock.hpp"
#include "tournaments/league/book.hpp"
#include "tournaments/league/league_store.hpp"

#include <nlohmann/json.hpp>

namespace mirocup::league {

// A file that the host hands in for a team.
struct HandIn {
  std::string team;
  std::string path;
  std::int64_t at = 0;     // s since 1970
  std::string house = {};  // "house:NAME" if the file is that of a house team
};

// The answer to a hand-in.
struct Submission {
  bool is_accepted = false;
  int entry = 0;        // the entry's number; 0: not kept
  int plays = 0;        // the entry that plays after a refusal; 0: none
  std::string message;  // a sentence for the team
  Json verdict = {};    // of the check, as in verdict.json; null if no check ran
};

// Returns why the league takes no entry of this team at this time (UTC, as in league.json); "" if
// the league takes it. An unknown team may join before the start.
std::string why_not_now(const LeagueState& state, const std::string& team, const std::string& now);

// Whether a team may hand in, and until when.
struct HandInTerms {
  std::string why_not = {};   // a sentence; "": its file is taken, perhaps late
  bool is_late = false;       // its file comes after the deadline: it is kept, and the host decides
  std::string deadline = {};  // UTC; "": the format alone decides
};
HandInTerms hand_in_terms(const LeagueState& state, const std::string& team,
                          const std::string& now);

// Returns why no team of this name can join the league; "" if a team can.
std::string why_not_join(const LeagueState& state, const std::string& team);

// Adds teams to a league: before the start in league.json, after the start in the journal. `source`
// is TeamConfig::source. The caller holds Folder::submitting(). Precondition: why_not_join() is "".
Result<void> enter_teams(system::Files& files, LeagueStore& store,
                         const std::vector<std::string>& teams, const std::string& source);

// Does all that follows from the lines of the book about a team and is not done yet: the team joins
// the league with its first accepted entry, each kept entry has its entry.json unless it came late
// and is not taken, no other entry has files, and in a ladder that has started the journal names
// the entry that plays. The caller holds Folder::submitting().
Result<void> follow_book(system::Files& files, LeagueStore& store, const HandIns& hand_ins,
                         const std::string& team);

// Compiles and checks a stored entry, of which `team`, `entry`, `file` and `is_network` count, and
// writes the verdict beside it. `compile_seconds` is the limit of processor time for a source.
// Returns the verdict; errors are faults of the host.
Result<Json> check_entry(system::Files& files, const Folder& folder, const HandedIn& handed,
                         int compile_seconds = 60);

// Returns the verdict that a check has left; null if there is none.
Result<Json> read_verdict(system::Files& files, const Folder& folder, const std::string& team,
                          int number);

// A league while a line of the book is written with all that follows from it. No other process does
// the same at the same time.
class Booking {
 public:
  // Waits for other processes. Errors: those of LeagueStore::open().
  static Result<Booking> begin(system::Files& files, const Folder& folder);

  // Calls follow_book().
  Result<void> follow(const HandIns& hand_ins, const std::string& team);

  // Takes an entry that came after the deadline. Returns a sentence that says why not; "" if it
  // plays from now on.
  Result<std::string> take_late(Book& book, const std::string& team, int number, std::int64_t now);

  // Pins an entry, which plays until another entry is pinned. If `number` is 0, the latest accepted
  // entry plays again. Returns a sentence that says why the entry cannot be pinned; "" if it was
  // pinned.
  Result<std::string> pin(Book& book, const std::string& team, int number, std::int64_t now);

  // Writes the answer to a checked hand-in. The entry is not taken if the league has stopped to
  // take entries since it was handed in.
  Result<Submission> conclude(Book& book, const std::string& team, int entry, Json verdict,
                              std::int64_t now, const Quota& quota = {});

  const LeagueState& state() const { return store_.state(); }

 private:
  Booking(system::Files& files, system::FileLock alone, LeagueStore store)
      : files_(files), alone_(std::move(alone)), store_(std::move(store)) {}

  system::Files& files_;
  system::FileLock alone_;
  LeagueStore store_;
};

// Hands in a library for a team. Before the start of the league, a team that is not in league.json
// joins with its first accepted entry; its name must differ from those of other teams in more than
// capital letters. A mistake in the file and a used-up quota give a Submission that says so; errors
// are faults of the host or of the call.
//
// The file is opened once and read into memory, before any lock is taken. The bytes in memory are
// checked, hashed and kept.
Result<Submission> submit(system::Files& files, const Folder& folder, const HandIn& handed,
                          const Quota& quota = {});

}  // namespace mirocup::league
