// SPDX-License-Identifier: MIT
//
// A copy of a league's folder, which may be taken while the league is played and while teams hand
// in. Files that a line of a journal names are on disk before the line. So the journals are read
// first and written last: the copy has all files that its journals name, and `league start` in the
// copy continues from there.
#pragma once

#include "tournaments/league/folder.hpp"

#include <string>

namespace mirocup::league {

struct BackupCount {
  int copied = 0;
  int known = 0;  // records that the copy already had; records never change
};

// Copies a league to a folder that is new or holds an earlier copy of it. Does not copy pages
// (`site`), locks and files that are arriving. After an error, or if this process dies, an earlier
// copy is still whole. Errors: Errc::input if the folder holds something else, another league, or a
// copy with decisions of its own, or is inside the league's own folder.
Result<BackupCount> back_up(system::Files& files, const Folder& from, const Folder& to);

}  // namespace mirocup::league
