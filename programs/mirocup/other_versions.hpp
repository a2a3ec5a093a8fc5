// SPDX-License-Identifier: MIT
//
// Other versions of mirocup on this computer, which play as they did when their records were made.
#pragma once

#include "record/match_record.hpp"

#include <string>

namespace mirocup::app {

// Returns the path of a program that reproduces the record at `path`; "" if there is none. Its
// checksum has to be right: the caller has looked. Programs are looked for in the folders of
// $MIROCUP_VERSIONS and in /opt/mirocup/*, each in bin/ and in the folder itself. One is asked if
// no stranger can have put it there (system/trusted_program.hpp), it is called mirocup, and it
// answers --version with the version that the record names. Standard error names each one that is
// left out because a stranger might have put it there.
std::string version_that_reproduces(const std::string& path, const record::MatchRecord& record);

}  // namespace mirocup::app
