// SPDX-License-Identifier: MIT
//
// The file tree of a team's process in tier T2: the system's library folders, the team's library,
// and nothing else; nothing can be written.
#pragma once

namespace mirocup::plugins {

inline constexpr int no_entry = -1;

// Where the team's library is in that tree.
inline constexpr const char* private_entry_path = "/entry/strategy.so";

// The folders that the dynamic loader looks into, and the one that Debian's choices between
// libraries are links in. Those that are missing are left out.
inline constexpr const char* library_folders[] = {
    "/lib", "/lib64", "/usr/lib", "/usr/lib64", "/usr/local/lib", "/etc/alternatives"};
inline constexpr const char* loader_cache = "/etc/ld.so.cache";

// Makes the tree, with a copy of the library that is open as `entry`, and makes it the root. To be
// called in a mount namespace of one's own, after fork: allocates nothing. Returns null, or the
// step that failed; then errno says why.
const char* enter_private_root(int entry);

}  // namespace mirocup::plugins
