// SPDX-License-Identifier: MIT
//
// A folder into which teams copy TEAM.so. A mistake in a file is reported in the answer to that
// file, and never stops another file.
#pragma once

#include "tournaments/league/submission.hpp"

#include <functional>

namespace mirocup::league {

// Called with the path of a file, its team ("" if the file's name is not that of a team) and the
// answer.
using InboxListener = std::function<void(const std::string& path, const std::string& team,
                                         const Result<Submission>& answer)>;

// Hands in each TEAM.so of the inbox, and reports the files that are new. `now` is in s since 1970.
// Files of different users take turns, so that no user waits for all files of another user. An
// error means that the inbox cannot be read, or that the user has interrupted the program.
Result<void> submit_inbox(system::Files& files, const Folder& folder, const std::string& inbox,
                          std::int64_t now, const InboxListener& tell, const Quota& quota = {});

}  // namespace mirocup::league
