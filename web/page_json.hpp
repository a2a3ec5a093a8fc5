// SPDX-License-Identifier: MIT
//
// The JSON that pages get from the program; page/main.js reads it.
#pragma once

#include "record/match_record.hpp"
#include "record/statistics/statistics.hpp"
#include "web/track_encoder.hpp"

namespace mirocup::web {

using record::Json;

// Returns the values of a scene that seldom change from tick to tick: {state, phase, left, score}.
Json moment_json(const match::Snapshot& scene);

// Returns the robots that count as keepers, blue's and yellow's; -1 if the team has no keeper.
Json keepers_json(const match::Snapshot& scene);

// Returns the leg's statistics in the form of `mirocup stats` (docs/statistics.md) but without the
// lists of goals and fouls, which pages take from the decisions: {play_s, …, teams: {blue,
// yellow}}.
Json statistics_json(const statistics::LegStatistics& leg);

// Returns the text of a server-sent event.
std::string event_text(const char* name, const Json& data);

}  // namespace mirocup::web
