// SPDX-License-Identifier: MIT
//
// What pages are told, as JSON: page/main.js reads it.
#pragma once

#include "server/record/match_record.hpp"
#include "server/web/statistics.hpp"
#include "server/web/track_encoder.hpp"

namespace mirocup::web {

using record::Json;

// What holds from a tick on: {state, phase, left, score}.
Json moment_json(const match::Snapshot& scene);

// {teams: {blue, yellow}, heat}. `fouls` counts the decisions that gave the other
// team a restart.
Json statistics_json(const Statistics& statistics,
                     const std::vector<match::LoggedDecision>& decisions);

// A server-sent event.
std::string event_text(const char* name, const Json& data);

}  // namespace mirocup::web
