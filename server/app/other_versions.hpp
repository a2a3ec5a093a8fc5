// SPDX-License-Identifier: MIT
//
// Other versions of mirocup on this computer, which play as they did when their records were made.
#pragma once

#include <string>
#include <vector>

namespace mirocup::app {

// Returns the paths of their programs: those in the folders of $MIROCUP_VERSIONS, in
// /opt/mirocup/*/bin, and beside the prefix of this program. This program is not among them. Beside
// the prefix a program counts only if it and its folder belong to root, this user or the owner of
// this program, and other users may not write to them.
std::vector<std::string> other_versions();

// Returns the first of them that reproduces the record; "" if none does.
std::string version_that_reproduces(const std::string& record);

}  // namespace mirocup::app
