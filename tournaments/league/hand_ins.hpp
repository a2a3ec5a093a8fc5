// SPDX-License-Identifier: MIT
//
// The memory of a league about each team that hands in: the user whose files count, and its last
// tries. It is in entries/TEAM/hand-ins.json, beside the versions. Only the host reads it.
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
  int tries_per_hour = 20;  // checked files, accepted or not
  int versions = 20;        // kept of each team, and beside them all that were booked to play

  // The most teams for which one user of a shared inbox may hand in. The host and the owner of the
  // inbox may hand in for any number.
  int teams_per_user = 8;
};

// One file that was handed in and checked.
struct Try {
  std::int64_t at = 0;        // s since 1970
  std::optional<uid_t> user;  // of a shared inbox; empty: the host
  int entry = 0;              // its number; 0: it was not stored
  bool is_accepted = false;
  std::string message;  // the answer that the host saw
};

struct HandIns {
  // The user whose files count, because a file of this user in a shared inbox was accepted. Empty
  // before that.
  std::optional<uid_t> owner;
  std::optional<uid_t> last_user;  // the last user of a shared inbox who tried
  int pinned = 0;                  // the entry that the team wants to play; 0: its latest
  std::string last_file;           // identifies the last file refused unread; "": none
  std::vector<Try> tries;          // the last ones, oldest first
};

// Reads the memory about a team, which is empty for a new team. A damaged file is Errc::damaged.
Result<HandIns> read_hand_ins(system::Files& files, const Folder& folder, const std::string& team);

Result<void> write_hand_ins(system::Files& files, const Folder& folder, const std::string& team,
                            const HandIns& known);

// Returns the entry that plays for a team from now on: the entry that it has pinned, if that is
// kept, otherwise its last accepted entry; 0 if there is none.
Result<int> playing_entry(system::Files& files, const Folder& folder, const std::string& team);

// Adds a try, and drops tries that no quota needs.
void add_try(HandIns& known, Try next);

// Returns the last try of that entry; null if it was dropped.
Try* find_try(HandIns& known, int entry);

// The number of tries of this user in the hour before `now`: so no user uses up the tries of
// another. A clock that jumps by more than an hour does not lock a team out.
int tries_in_last_hour(const HandIns& known, std::int64_t now, const std::optional<uid_t>& user);

// The number of teams for which this user hands in or has tried to.
Result<int> teams_of_user(system::Files& files, const Folder& folder, uid_t user);

// Removes versions beyond the quota, refused ones first, and the library of each refused version
// but the newest. The versions in `played`, the pinned version, the last accepted version and the
// newest version stay.
Result<void> prune_versions(system::Files& files, const Folder& folder, const std::string& team,
                            const std::vector<int>& played, const Quota& quota);

}  // namespace mirocup::league
