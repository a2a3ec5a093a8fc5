// SPDX-License-Identifier: MIT
//
// Limits a team's process with Landlock: it may read libraries while it loads, then no files at
// all. If the kernel's Landlock can forbid it, the process may also not use the network or send
// signals to other processes.
#pragma once

namespace mirocup::plugins {

// Whether the process may list the library folders while it loads, as Python's import does.
enum class Folders { hidden, listed };

// Returns the version of the kernel's Landlock; 0 or less if it has none.
int landlock_version();

// allow_libraries_only(): from here on this process may only read files below the library folders
// and, if it is not null, `entry_path`. After allow_no_files(), which is called later, it may read
// no file at all. Neither can be undone. They return false on failure; errno says why.
bool allow_libraries_only(const char* entry_path, Folders folders);
bool allow_no_files();

}  // namespace mirocup::plugins
