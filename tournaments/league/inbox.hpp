// SPDX-License-Identifier: MIT
//
// A folder into which teams copy TEAM.so. Each file is taken by itself: what is wrong with one is
// its message and never stops another.
#pragma once

#include "tournaments/league/submission.hpp"

#include <functional>

namespace mirocup::league {

// Is told what became of a file: its path, its team ("" if its name is no team's), the answer.
using InboxListener = std::function<void(const std::string& path, const std::string& team,
                                         const Result<Submission>& answer)>;

// Hands in each TEAM.so of the inbox, and tells about those that are news. `now` is in s since
// 1970. Files of different users take turns, so that nobody waits for all files of another. An
// error means that the inbox cannot be read, or that the user has interrupted.
Result<void> submit_inbox(system::Files& files, const Folder& folder, const std::string& inbox,
                          std::int64_t now, const InboxListener& tell, const Quota& quota = {});

}  // namespace mirocup::league
