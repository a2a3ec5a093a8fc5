// SPDX-License-Identifier: MIT
//
// What a league remembers of each team that hands in: whose files count, and its last tries. It is
// in entries/TEAM/hand-ins.json, beside the versions. Only the host reads it.
#pragma once

#include "tournaments/league/folder.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <sys/types.h>
#include <vector>

namespace mirocup::league {

// What a team may hand in. The size of an entry is system::size_limit::entry.
struct Quota {
  int tries_per_hour = 20;  // that were looked at, accepted or not
  int versions = 20;        // kept of each team, and beside them all that were booked to play

  // Teams for which one user may hand in, of the users who share an inbox. The host, and the owner
  // of the inbox, hand in for any number.
  int teams_per_user = 8;
};

// One file that was handed in and looked at.
struct Try {
  std::int64_t at = 0;        // s since 1970
  std::optional<uid_t> user;  // of a shared inbox; nothing: the host
  int entry = 0;              // its number; 0: it was not stored
  bool is_accepted = false;
  std::string message;  // what the host was told
};

struct HandIns {
  // The user whose files count, since a file of this user in a shared inbox was accepted. Nothing:
  // nobody is bound yet.
  std::optional<uid_t> owner;
  std::optional<uid_t> last_user;  // of a shared inbox who tried last, accepted or not
  int pinned = 0;                  // the entry that the team wants to play; 0: its latest
  std::string last_file;           // tells the file that was refused unread last; "": none was
  std::vector<Try> tries;          // the last ones, oldest first
};

// Reads what is remembered of a team; of a new team nothing. A damaged file is Errc::damaged.
Result<HandIns> read_hand_ins(system::Files& files, const Folder& folder, const std::string& team);

Result<void> write_hand_ins(system::Files& files, const Folder& folder, const std::string& team,
                            const HandIns& known);

// Returns the entry that plays for a team from now on: the one that it has pinned, as long as that
// is kept, or its last accepted one; 0 if there is none.
Result<int> playing_entry(system::Files& files, const Folder& folder, const std::string& team);

// Adds a try, and forgets those that no quota needs.
void add_try(HandIns& known, Try next);

// Returns the last try of that entry; null if it is forgotten.
Try* find_try(HandIns& known, int entry);

// The number of tries of this user in the hour before `now`: nobody uses up the tries of another. A
// clock that was set back or forth by more than an
// hour neither locks a team out nor in.
int tries_in_last_hour(const HandIns& known, std::int64_t now, const std::optional<uid_t>& user);

// The number of teams for which this user hands in or has tried to.
Result<int> teams_of_user(system::Files& files, const Folder& folder, uid_t user);

// Removes versions beyond the quota, refused ones first, and the library of each refused version
// but the newest. Versions in `played`, the one that is pinned, the last that was
// accepted and the newest stay.
Result<void> prune_versions(system::Files& files, const Folder& folder, const std::string& team,
                            const std::vector<int>& played, const Quota& quota);

}  // namespace mirocup::league
