// SPDX-License-Identifier: MIT
//
// The roster of a league for its staff. A row has a team's members, its last hand-in with the
// answer, and other teams that have handed in the same file.
#pragma once

#include "tournaments/league/hand_ins.hpp"
#include "tournaments/league/league_store.hpp"
#include "tournaments/league/people.hpp"

#include <string>
#include <vector>

namespace mirocup::league {

struct RosterRow {
  std::string team;
  People people;
  bool is_house = false;
  // False: the team is in the class list or has handed in, but is not in the league.
  bool has_joined = true;
  TeamStatus status = TeamStatus::playing;
  std::string why;        // the reason why the team is paused or has withdrawn
  int playing_entry = 0;  // the entry that plays, by the journal; 0: none yet
  int last_accepted = 0;  // the pinned entry, otherwise the last accepted entry; 0: none
  int last_entry = 0;     // number of the last kept entry
  std::string handed_in;  // time of the last hand-in, UTC; "": never, or the host gave the library
  bool was_accepted = false;         // the last try was accepted
  bool has_ended = true;             // false: the check of the last try is running, or was stopped
  std::string message;               // the answer to the last try
  std::string sha256;                // of the last kept entry; "": no entry
  std::vector<std::string> same_as;  // other teams whose entry is the same file
  // Sentences that say why the team may need help: warnings about its accepted entry, legs that it
  // lost by its own faults, that it has lost every leg or has fallen by many ranks.
  std::vector<std::string> notes;

  // True if the team, which is none of the house, has never handed in.
  bool is_missing() const { return last_entry == 0 && handed_in.empty() && !is_house; }

  // True if the last try has an answer, and was not accepted.
  bool was_refused() const { return !handed_in.empty() && has_ended && !was_accepted; }

  // Returns "nothing handed in", "accepted", "refused", "waits for its check" or "given by the
  // host".
  std::string state() const;

  // Returns ", plays with entry 3", and whether the team is paused, has withdrawn or has not
  // joined.
  std::string standing() const;

  // Returns what the team and the host should know, without the team's name: that nothing was
  // handed in or that the last hand-in waits, the last refusal, and `notes`.
  std::vector<std::string> told() const;
};

// Returns the teams of the class list, all other teams of the league, and all other names that have
// handed in.
Result<PeopleOfTeams> everybody(system::Files& files, const LeagueStore& store);

// Returns a row for each team that is in the league or in the class list, has a token, or has
// handed in.
Result<std::vector<RosterRow>> roster(system::Files& files, const LeagueStore& store,
                                      const HandIns& hand_ins);

// Returns the time of the last line of the journal about a leg that was played, UTC; "" if no such
// line exists or the line has no time.
std::string last_leg_at(const Journal& journal);

// Returns the roster as JSON, for `status --entries --json`.
Json roster_json(const std::vector<RosterRow>& rows);

}  // namespace mirocup::league
