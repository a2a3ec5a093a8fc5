// SPDX-License-Identifier: MIT
//
// Other versions of mirocup on this computer, which play as they did when their records were made.
#pragma once

#include "record/match_record.hpp"

#include <string>

namespace mirocup::app {

// Returns the path of a program that reproduces the record at `path`; "" if no such program exists.
// Precondition: the record's checksum is right. The function looks for programs in the folders of
// $MIROCUP_VERSIONS and in /opt/mirocup/*, each in bin/ and in the folder itself. It runs only
// programs that are called mirocup and that no stranger can have put there
// (system/trusted_program.hpp). `--version` must print the version that the record names. Standard
// error names each program that a stranger might have put there.
std::string version_that_reproduces(const std::string& path, const record::MatchRecord& record);

}  // namespace mirocup::app
