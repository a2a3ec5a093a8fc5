// SPDX-License-Identifier: MIT
//
// The football statistics of a league: of each leg that counts and has a record, according to the
// journal. A leg is counted once, when its replay page is made; site/statistics/LEG.json keeps the
// numbers.
#pragma once

#include "record/statistics/report.hpp"
#include "tournaments/league/folder.hpp"
#include "tournaments/publish/bests.hpp"
#include "tournaments/publish/leg_view.hpp"
#include "tournaments/publish/site_file.hpp"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace mirocup::league {

using LegReports = std::vector<statistics::LegReport>;

// Returns the path inside site/ of the statistics of a record ("records/x.json").
std::string statistics_file_of(const std::string& record);

// True if the statistics of that record are kept in a form that this program reads.
bool has_statistics(system::Files& files, const Folder& folder, const std::string& record);

// Reports that were read, by the path of the record inside the league folder.
using KnownReports = std::map<std::string, statistics::LegReport>;

// Returns the kept reports of the legs that count, in the order of the schedule. Leaves out a leg
// whose file is missing, damaged or of another leg. `known`, if not null, has the reports that were
// read before, which do not change, and gets those that are read now.
LegReports kept_statistics(system::Files& files, const Folder& folder, const LeagueState& state,
                           KnownReports* known = nullptr);

// As above, but plays legs without a kept report again. Writes nothing. Errors: those of
// statistics::count_record().
Result<LegReports> all_statistics(system::Files& files, const Folder& folder,
                                  const LeagueState& state);

// Returns the team whose robots kept out the greatest share of the shots on their goal, as a best
// of the league. Returns nothing if no team has faced least_shots of them.
inline constexpr int least_shots = 10;
std::optional<Best> best_goalkeeper(const Overview& overview, const LegReports& reports);

// The part of the league's page: each team over all its legs; "" if nothing has been counted.
std::string statistics_html(const Overview& overview, const LegReports& reports);

// The part of a team's page: its numbers, as blue and as yellow, and how goals fell against it.
std::string team_statistics_html(const Overview& overview, const LegReports& reports, int team);

// statistics.json, statistics.csv and goals.csv. Refers to the reports.
FileMakers statistics_exports(const LegReports& reports);

}  // namespace mirocup::league
