// SPDX-License-Identifier: MIT
//
// The memory of a league about each team that hands in: its pinned entry and its last tries. The
// memory is in entries/TEAM/hand-ins.json, beside the entries. Only the host can read the file.
#pragma once

#include "tournaments/league/folder.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace mirocup::league {

// The limits of hand-ins. The size of an entry is system::size_limit::entry.
struct Quota {
  int tries_per_hour = 20;  // checked files, accepted or not
  // The most kept entries of each team, besides all entries that were booked to play.
  int versions = 20;
};

// One file that was handed in and checked.
struct Try {
  std::int64_t at = 0;  // s since 1970
  int entry = 0;        // the number of the stored entry; 0: not stored
  bool is_accepted = false;
  std::string message;  // the answer that the host saw
};

struct HandIns {
  int pinned = 0;          // the entry with which the team wants to play; 0: its latest
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

// Returns the number of tries in the hour before `now`. A jump of the clock by more than an hour
// does not lock a team out.
int tries_in_last_hour(const HandIns& known, std::int64_t now);

// Removes entries beyond the quota, refused entries first, and the library of each refused entry
// but the newest. The entries in `played`, the pinned, the last accepted and the newest entry stay.
Result<void> prune_versions(system::Files& files, const Folder& folder, const std::string& team,
                            const std::vector<int>& played, const Quota& quota);

}  // namespace mirocup::league
