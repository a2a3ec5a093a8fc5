// SPDX-License-Identifier: MIT
//
// Which files of this computer nobody but root and this user, the effective one, can have put where
// they are. No other program is run in place of this one, and no other list of programs is read.
#pragma once

#include "core/base/error.hpp"

#include <string>

namespace mirocup::system {

// Set in the environment of a version of mirocup that another one asks: it asks none itself.
inline constexpr const char* asks_no_other = "MIROCUP_IS_ASKED";

// Returns the real path of a file or folder, which strangers cannot change as long as root and this
// user leave it. A relative path begins at the working folder. Each name and each link on the way,
// from / on, belongs to root or to this user; nobody else may
// write to it. A folder of root's with the sticky bit may be open to all, such as /tmp. In such a
// folder only what belongs to this user counts. It may not be mounted there, and a file has one
// name only, since strangers may mount their own file systems and link to files of others.
//
// Only bits of the mode are looked at. Of a POSIX access list, the bits of the group show the most
// that it grants to anybody, so one that lets others write is refused; lists of NFS are not seen.
//
// Errors: Errc::input if the path is not trusted, with the name and the reason; Errc::unavailable
// if a name is not there or cannot be read.
Result<std::string> trusted_path(const std::string& path);

// The same for a program, whose real name must be `name`: a link to another program is refused
// (Errc::input), and so is what is not a regular file that this user may run.
Result<std::string> trusted_program(const std::string& path, const std::string& name);

}  // namespace mirocup::system
