// SPDX-License-Identifier: MIT
//
// Limits a team's process with Landlock: the process may read libraries while it loads, and later
// no files at all. As far as the kernel's Landlock can forbid it, the process may also not use the
// network or send signals to other processes.
#pragma once

namespace mirocup::plugins {

// Whether the process may list the library folders while it loads, as Python's import does.
enum class Folders { hidden, listed };

// Returns the version of the kernel's Landlock; 0 or less if the kernel has no Landlock.
int landlock_version();

// After allow_libraries_only() this process may only read files below the library folders and, if
// not null, `entry_path`. After allow_no_files(), to be called later, this process may read no
// file. Neither call can be undone. Both return false on failure; errno says why.
bool allow_libraries_only(const char* entry_path, Folders folders);
bool allow_no_files();

}  // namespace mirocup::plugins
