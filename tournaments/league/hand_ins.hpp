// SPDX-License-Identifier: MIT
//
// The memory of a league about each team that hands in: the user whose files count for the team,
// and the team's last tries. The memory is in entries/TEAM/hand-ins.json, beside the entries. Only
// the host can read the file.
#pragma once

#include "tournaments/league/folder.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <sys/types.h>
#include <vector>

namespace mirocup::league {

// The limits of hand-ins. The size of an entry is system::size_limit::entry.
struct Quota {
  int tries_per_hour = 20;  // checked files, accepted or not
  // The most kept entries of each team, besides all entries that were booked to play.
  int versions = 20;

  // The most teams for which one user of a shared inbox may hand in. The host and the owner of the
  // inbox may hand in for any number of teams.
  int teams_per_user = 8;
};

// One file that was handed in and checked.
struct Try {
  std::int64_t at = 0;        // s since 1970
  std::optional<uid_t> user;  // the user of a shared inbox; empty: the host
  int entry = 0;              // the number of the stored entry; 0: not stored
  bool is_accepted = false;
  std::string message;  // the answer that the host saw
};

struct HandIns {
  // The user whose files count, because a file of this user in a shared inbox was accepted. Empty
  // before the first such file.
  std::optional<uid_t> owner;
  std::optional<uid_t> last_user;  // the last user of a shared inbox who tried
  int pinned = 0;                  // the entry with which the team wants to play; 0: its latest
  // Identifies the last file that was refused without being read; "": none.
  std::string last_file;
  std::vector<Try> tries;  // the last tries, oldest first
};

// Reads the memory about a team, which is empty for a new team. A damaged file is Errc::damaged.
Result<HandIns> read_hand_ins(system::Files& files, const Folder& folder, const std::string& team);

Result<void> write_hand_ins(system::Files& files, const Folder& folder, const std::string& team,
                            const HandIns& known);

// Returns the entry that plays for a team from now on: the pinned entry if it is kept, otherwise
// the last accepted entry; 0 if the team has neither.
Result<int> playing_entry(system::Files& files, const Folder& folder, const std::string& team);

// Adds a try, and drops tries that no quota needs.
void add_try(HandIns& known, Try next);

// Returns the last try of an entry; null if the try was dropped.
Try* find_try(HandIns& known, int entry);

// Returns the number of tries of a user in the hour before `now`. Tries are counted by user, so
// that no user uses up the tries of another. A jump of the clock by more than an hour does not lock
// a team out.
int tries_in_last_hour(const HandIns& known, std::int64_t now, const std::optional<uid_t>& user);

// Returns the number of teams for which a user hands in or has tried to hand in.
Result<int> teams_of_user(system::Files& files, const Folder& folder, uid_t user);

// Removes entries beyond the quota, refused entries first, and the library of each refused entry
// but the newest. The entries in `played`, the pinned, the last accepted and the newest entry stay.
Result<void> prune_versions(system::Files& files, const Folder& folder, const std::string& team,
                            const std::vector<int>& played, const Quota& quota);

}  // namespace mirocup::league
