// SPDX-License-Identifier: MIT
//
// Checks that only root or this (effective) user can have created the file at a given path. Only
// a program that passes may replace mirocup, and mirocup reads its list of programs only from a
// file that passes.
#pragma once

#include "core/base/error.hpp"

#include <string>

namespace mirocup::system {

// Set in the environment of a version of mirocup that another version has started, so that it does
// not start a third version.
inline constexpr const char* asks_no_other = "MIROCUP_IS_ASKED";

// Returns the time, s, in which another version has to simulate a leg again. A half of the leg has
// `half_s` seconds, which a version simulates in some hundredths of this time.
inline double limit_of_repeating(double half_s) {
  return 60.0 + half_s;
}

// Returns the real path of a file or folder, at which strangers cannot put anything else. A
// relative path begins at the working folder. Each name and each link on the way from / must belong
// to root or to this user, and nobody else may write to it. Only a folder of root with the sticky
// bit, such as /tmp, may be open to all. What lies in such a folder must belong to this user and
// must not be a mount point, and a file there must have one name only, because strangers may mount
// their own file systems there and link to files of others.
//
// The check looks only at the bits of the mode. The group bits of a file with a POSIX access
// control list show the most that the list grants to anybody, so a list that lets others write is
// refused. The check does not see lists of NFS.
//
// Errors: Errc::input if the path is not trusted, with the name and the reason; Errc::unavailable
// if a name does not exist or cannot be read.
Result<std::string> trusted_path(const std::string& path);

// Like trusted_path(), for a program, whose real name must be `name`. A link to another program is
// refused (Errc::input), as is everything but a regular file that this user may run.
Result<std::string> trusted_program(const std::string& path, const std::string& name);

}  // namespace mirocup::system
