// SPDX-License-Identifier: MIT
//
// The file tree of a team's process in tier T2: the system's library folders and the team's
// library, all read-only, and nothing else.
#pragma once

namespace mirocup::plugins {

inline constexpr int no_entry = -1;

// The path of the team's library in that tree.
inline constexpr const char* private_entry_path = "/entry/strategy.so";

// The folders that the dynamic loader searches, and the one that holds the links of Debian's
// alternatives. Missing ones are left out.
inline constexpr const char* library_folders[] = {
    "/lib", "/lib64", "/usr/lib", "/usr/lib64", "/usr/local/lib", "/etc/alternatives"};
inline constexpr const char* loader_cache = "/etc/ld.so.cache";

// Makes the tree, with a copy of the library that is open as `entry` (or no_entry), and makes it
// the root. The process must be in a mount namespace of its own. Allocates nothing, so it may be
// called after fork. Returns null on success, else the step that failed; errno says why.
const char* enter_private_root(int entry);

}  // namespace mirocup::plugins
