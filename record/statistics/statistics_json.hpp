// SPDX-License-Identifier: MIT
//
// The JSON of statistics, schema mirocup/statistics/1: docs/statistics.md describes it. Pages, the
// output of `mirocup stats --json` and the files of a league hold the same objects.
#pragma once

#include "record/statistics/leg_report.hpp"

#include <nlohmann/json_fwd.hpp>

#include <string_view>

namespace mirocup::statistics {

using record::Json;

// Returns the statistics of a leg without its record and names: {play_s, dead_ball_s, …, teams,
// goals, fouls}.
Json to_json(const LegStatistics& statistics);

// Returns the statistics of a leg with its record and the names of its teams.
Json to_json(const LegReport& leg);

Json to_json(const TeamTotals& team);

// Returns the whole document: {schema, legs, teams}.
Json report_json(const std::vector<LegReport>& legs);

// Reads the text of one leg in the form of `to_json(LegReport)`. Errors: Errc::damaged, also for a
// text of another version.
Result<LegReport> parse_leg_report(std::string_view text, const std::string& path);

// Returns the text of the file that keeps a leg's statistics beside its replay page.
std::string leg_report_text(const LegReport& leg);

}  // namespace mirocup::statistics
