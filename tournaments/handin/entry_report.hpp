// SPDX-License-Identifier: MIT
//
// The report of one entry for its team, in the form of the HTTP API: state, reason, the result of
// each check, times, the log. A report names no path and no user of the host.
#pragma once

#include "tournaments/league/folder.hpp"
#include "tournaments/league/hand_ins.hpp"

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

// Returns the report of an entry. A verdict that cannot be read is an error. `before` is
// HandIns::before(). Only if `is_whole`, the report has checks, times and log.
Result<Json> entry_report(system::Files& files, const Folder& folder, const HandedIn& handed,
                          int before, const CheckStep& step, bool is_whole);

// Returns the first and the last lines of a log, short enough for a person.
std::string shortened(const std::string& log);

}  // namespace mirocup::league
