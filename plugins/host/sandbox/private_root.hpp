// SPDX-License-Identifier: MIT
//
// The file tree of a team's process in tier T2: the system's library folders and the team's
// library, all read-only, and nothing else.
#pragma once

#include <initializer_list>
#include <sys/types.h>

namespace mirocup::plugins {

inline constexpr int no_entry = -1;

// The path of the team's library in the tree.
inline constexpr const char* private_entry_path = "/entry/strategy.so";

// The folders that the dynamic loader searches, and the folder with the links of Debian's
// alternatives. Missing folders are left out.
inline constexpr const char* library_folders[] = {
    "/lib", "/lib64", "/usr/lib", "/usr/lib64", "/usr/local/lib", "/etc/alternatives"};
inline constexpr const char* loader_cache = "/etc/ld.so.cache";

// Makes the tree, with a copy of the library that is open as `entry` (or no_entry), and makes the
// tree the root. Precondition: the process has its own mount namespace. The function allocates
// nothing, so it may be called after fork. Returns null on success, otherwise the step that failed;
// errno says why.
const char* enter_private_root(int entry);

// The common steps of making file trees. begin_root() makes a tree in a tmpfs with these mount
// options, enters it, makes the folders and shows the library folders. change_root() makes the tree
// that was entered the root of the process. Both functions return null on success, otherwise the
// step that failed.
const char* begin_root(const char* options, std::initializer_list<const char*> folders);
const char* change_root();

// Shows a folder of the system in the tree, read-only. If the folder is a symbolic link, as /lib is
// on most systems, the tree gets the link. A missing folder is left out.
bool show_folder(const char* path);

bool make_read_only(const char* path);

// Sends that many bytes, from the beginning of a file on. Allocates nothing.
bool send_file(int to, int from, off_t size);

}  // namespace mirocup::plugins
