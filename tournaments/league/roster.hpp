// SPDX-License-Identifier: MIT
//
// The roster of a league for its staff. A row has a team's members, its last hand-in with the
// answer, and other teams that have handed in the same file.
#pragma once

#include "tournaments/league/league_store.hpp"
#include "tournaments/league/people.hpp"

#include <string>
#include <vector>

namespace mirocup::league {

struct RosterRow {
  std::string team;
  People people;
  bool is_house = false;
  bool has_joined = true;  // false: in the class list or has handed in, but not in the league
  TeamStatus status = TeamStatus::playing;
  std::string why;        // why it is paused, or has withdrawn
  int playing_entry = 0;  // by the journal; 0: none yet
  int last_accepted = 0;  // the last entry that was accepted, or the pinned one; 0: none
  int last_entry = 0;     // number of the last kept entry
  std::string handed_in;  // when it last handed in, UTC; "": never, or the host gave the library
  bool was_accepted = false;         // the last try
  bool has_ended = true;             // false: its check is running, or was stopped
  std::string message;               // the answer to it
  std::string sha256;                // of that entry; ""
  std::vector<std::string> same_as;  // other teams whose entry is the same file

  // "nothing handed in", "accepted", "refused", "not checked to the end" or "given by the host".
  std::string state() const;
};

// Returns the class list, with each further team of the league and each further name that has
// handed in.
Result<PeopleOfTeams> everybody(system::Files& files, const LeagueStore& store);

// Returns a row for each team of the league, and for each other team that is in the class list, has
// a token or has handed in.
Result<std::vector<RosterRow>> roster(system::Files& files, const LeagueStore& store);

// Returns the time of the last line of the journal about a leg that was played, UTC; "" if there is
// none or it has no time.
std::string last_leg_at(const Journal& journal);

// The roster as JSON, for `status --entries --json`.
Json roster_json(const std::vector<RosterRow>& rows);

}  // namespace mirocup::league
