// SPDX-License-Identifier: MIT
//
// The users of this computer, and the files that they own.
#pragma once

#include <optional>
#include <string>
#include <sys/types.h>

namespace mirocup::system {

// Returns the number of the user whose rights this process has.
uid_t this_user();

// Returns the user's name for a sentence: "alice", or "user 1001" if the number has no name.
std::string name_of_user(uid_t user);

// Returns the owner of a file, or of the link if the path is a link; nothing if there is no file.
std::optional<uid_t> owner_of(const std::string& path);

}  // namespace mirocup::system
