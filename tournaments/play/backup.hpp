// SPDX-License-Identifier: MIT
//
// Copies a league's folder, also while the league is played and while teams hand in. The files that
// a line of a journal names are on disk before the line is written. So the journals are read first
// and written last. Thus the copy has all files that its journals name, and `league start` can
// continue the copy. Records and nights that came after the journals were read wait for the next
// copy, because the copy would not know their lines.
#pragma once

#include "tournaments/league/folder.hpp"

#include <set>
#include <string>

namespace mirocup::league {

struct BackupCount {
  int copied = 0;
  int known = 0;                // records that the earlier copy already had; records never change
  std::set<std::string> names;  // of all these files, inside the league
};

// Copies a league to a new folder, or to a folder with an earlier copy of the league. Does not copy
// pages (`site`), locks, and hand-ins that are still arriving. After an error, or if this process
// dies, an earlier copy is still whole. Errors: Errc::input if the folder holds something else,
// another league, or a copy with decisions that the league lacks, or if the folder is inside the
// league's folder.
Result<BackupCount> back_up(system::Files& files, const Folder& from, const Folder& to);

}  // namespace mirocup::league
