// SPDX-License-Identifier: MIT
//
// The report of one entry for its team, in the form of the HTTP API: state, reason, the result of
// each check, times, the log. A report names no path and no user of the host.
#pragma once

#include "tournaments/handin/queue.hpp"
#include "tournaments/league/folder.hpp"

#include <nlohmann/json.hpp>

namespace mirocup::league {

using Json = nlohmann::ordered_json;

// The check that is running.
struct CheckStep {
  int number = 0;  // from 1; 0: no check has begun
  int of = 0;
  std::string name;

  bool operator==(const CheckStep&) const = default;
};

// Returns the step that the last line of a check's answer tells; nothing if it tells none.
std::optional<CheckStep> step_in(const Json& answer);

// Returns the report of an entry; null if the team has no entry of that number. A verdict that
// cannot be read is an error, not a refusal. If `waiting` is null, the entry was not handed in over
// the network. `before` is HandInQueue::before(). Only if `is_whole`, the report has checks, times
// and log.
Result<Json> entry_report(system::Files& files, const Folder& folder, const std::string& team,
                          int entry, const WaitingHandIn* waiting, int before,
                          const CheckStep& step, bool is_whole);

// Returns the first and the last lines of a log, short enough for a person.
std::string shortened(const std::string& log);

}  // namespace mirocup::league
