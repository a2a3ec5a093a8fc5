// SPDX-License-Identifier: MIT
//
// The JSON that pages get from the program; page/main.js reads it.
#pragma once

#include "server/record/match_record.hpp"
#include "server/web/statistics.hpp"
#include "server/web/track_encoder.hpp"

namespace mirocup::web {

using record::Json;

// The values that hold from a tick on: {state, phase, left, score}.
Json moment_json(const match::Snapshot& scene);

// {teams: {blue, yellow}, heat}. `fouls` counts the decisions that gave the other team a restart.
Json statistics_json(const Statistics& statistics,
                     const std::vector<match::LoggedDecision>& decisions);

// Returns the text of a server-sent event.
std::string event_text(const char* name, const Json& data);

}  // namespace mirocup::web
