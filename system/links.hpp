// SPDX-License-Identifier: MIT
//
// Folders whose files may come from a stranger, for example the folder of a league: a link in such
// a folder could lead to any file of the host. The functions of files.hpp, and whatever else opens
// a file by its path there, ask for the way to it.
#pragma once

#include "core/base/error.hpp"
#include "system/descriptor.hpp"

#include <string>

namespace mirocup::system {

// From now on no way of this process leads over a link below the folder. The path of the folder
// itself may have links.
void follow_no_links_below(const std::string& folder);

// A path for the calls of the system. While the object lives, no new link gives the path another
// meaning.
struct Way {
  std::string path;
  Descriptor folder{};  // has the last name of the path, if the path begins in /proc/self/fd
};

// Returns the way to a path. Below a folder of follow_no_links_below() each folder is opened from
// the one above it. Errors: Errc::input, if one of them or the last name is a link, which the error
// names; Errc::unavailable with the reason why the path cannot be `done` ("read").
Result<Way> way_to(const std::string& path, const char* done);

}  // namespace mirocup::system
