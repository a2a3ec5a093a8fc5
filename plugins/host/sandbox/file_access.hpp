// SPDX-License-Identifier: MIT
//
// What a team's process may do to files, by Landlock: read libraries while it loads, then nothing.
// It also may not use the network, or signal anybody outside, where the kernel's Landlock can that.
#pragma once

namespace mirocup::plugins {

// Of the kernel's Landlock; 0 or less: it has none.
int landlock_version();

// From here on this process may only read below the library folders, and `entry_path` if that is
// not null; or nothing at all. Both last; the second goes on top of the first. False: errno says
// why.
bool allow_libraries_only(const char* entry_path);
bool allow_no_files();

}  // namespace mirocup::plugins
