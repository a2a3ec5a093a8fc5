// SPDX-License-Identifier: MIT
//
// What the referee says to a trace: one object of JSON, the first decision of the situation.
// docs/referee-traces.md has its keys.
#pragma once

#include "server/traces/trace.hpp"

namespace mirocup::traces {

nlohmann::ordered_json judge_trace(const Trace& trace);

// The verdict on a line that is no situation: REJECTED, with the reason.
nlohmann::ordered_json reject_trace(const std::string& id, const std::string& reason);

}  // namespace mirocup::traces
