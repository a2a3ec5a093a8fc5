// SPDX-License-Identifier: MIT
//
// The users of this computer, by number and by name, and the users that may write into a folder.
#pragma once

#include "core/base/error.hpp"

#include <optional>
#include <string>
#include <sys/types.h>

namespace mirocup::system {

// Returns the number of the user whose rights this process has.
uid_t this_user();

// Returns the user's name for a sentence: "alice", or "user 1001" if the number has no name.
std::string name_of_user(uid_t user);

// Returns the user with a name or number; nothing if the name does not exist.
std::optional<uid_t> find_user(const std::string& text);

// The users, besides the superuser, that may write into a folder.
struct FolderWriters {
  uid_t owner = 0;
  bool others_write = false;   // true: others may make files in the folder
  bool others_remove = false;  // true: others may also remove and rename each other's files
};
Result<FolderWriters> writers_of(const std::string& folder);

// Returns the owner of a file, or of the link if the path is a link; nothing if there is no file.
std::optional<uid_t> owner_of(const std::string& path);

}  // namespace mirocup::system
