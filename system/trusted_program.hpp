// SPDX-License-Identifier: MIT
//
// Tells whether only root and this (effective) user can have put a file at its path. mirocup
// replaces itself only with such a program, and reads only such a list of programs.
#pragma once

#include "core/base/error.hpp"

#include <string>

namespace mirocup::system {

// Set in the environment of a version of mirocup that another version runs, so that it does not run
// a third one.
inline constexpr const char* asks_no_other = "MIROCUP_IS_ASKED";

// Returns the real path of a file or folder, which strangers cannot change as long as root and this
// user do not change it. A relative path begins at the working folder. Each name and each link on
// the way from / must belong to root or to this user, and nobody else may write to it. A folder of
// root with the sticky bit may be open to all, such as /tmp. In such a folder everything must
// belong to this user, must not be a mount point, and a file must have one name only, since
// strangers may mount their own file systems there and link to files of others.
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
