// SPDX-License-Identifier: MIT
//
// The verdict on a trace: one JSON object with the first decision of the situation.
// docs/referee-traces.md describes its keys.
#pragma once

#include "record/traces/trace.hpp"

namespace mirocup::traces {

nlohmann::ordered_json judge_trace(const Trace& trace);

// Returns the verdict on a line that is not a situation: REJECTED, with the reason.
nlohmann::ordered_json reject_trace(const std::string& id, const std::string& reason);

}  // namespace mirocup::traces
