// SPDX-License-Identifier: MIT
//
// The browser modules (browser/) of the versions that played the records of a league. Only the
// version that played a leg is certain to repeat the course of the leg. So the league's folder
// keeps programs/GAME/mirocup.wasm beside records/, and a record of another version is verified by
// its module: node runs the installed verify.mjs, which can do nothing but call the module. Nothing
// else in the folder is ever run.
//
// A folder may come from another host. So a module is used only if its digest is on a list outside
// the folder. This host lists a module that it has kept itself, or that its user has called
// trusted.
#pragma once

#include "core/replay/verification.hpp"
#include "record/match_record.hpp"

#include <optional>
#include <string>
#include <vector>

namespace mirocup::record {

// Returns the time, s, in which a program has to simulate a leg again. A half of the leg has
// `half_s` seconds, which a program simulates in some hundredths of this time.
inline double limit_of_repeating(double half_s) {
  return 60.0 + half_s;
}

// Keeps the module of this program in the folder `league`, if the module was built, and puts it on
// this host's list. Replaces a module in its place that is not on the list. If the list cannot be
// read or written, keeps nothing and warns on standard error. Errors: the module cannot be read or
// written.
Result<void> keep_module(system::Files& files, const std::string& league);

// Puts all modules of the folder `league` on this host's list, and returns their paths.
Result<std::vector<std::string>> trust_modules(system::Files& files, const std::string& league);

// Verifies the record at `path` by the module of its version, which the folder above the record's
// folder has kept, and returns the first difference, or nothing if the leg is reproduced.
// Precondition: the record's checksum is right. Errors: Errc::unavailable if no such module is
// kept, if the host's list lacks it, or if node does not answer in time; the reason is a clause.
Result<std::optional<replay::Divergence>> verify_by_module(system::Files& files,
                                                           const std::string& path,
                                                           const MatchRecord& record);

}  // namespace mirocup::record
