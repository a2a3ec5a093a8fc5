// SPDX-License-Identifier: MIT
//
// The football statistics of a league, over each leg that counts and has a record in the journal.
// The program counts a leg once, when it makes the leg's replay page, and keeps the numbers in
// site/statistics/LEG.json.
#pragma once

#include "record/statistics/report.hpp"
#include "tournaments/league/folder.hpp"
#include "tournaments/publish/bests.hpp"
#include "tournaments/publish/leg_facts.hpp"
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

// Returns the state hash of the leg whose statistics are kept for a record; nothing if this program
// cannot read them.
std::optional<std::string> counted_hash(system::Files& files, const Folder& folder,
                                        const std::string& record);

// The reports of legs, by the path of the record inside the league folder.
using KnownReports = std::map<std::string, statistics::LegReport>;

// Returns the kept reports of the legs that count, in the order of the schedule. Leaves out a leg
// whose file is missing, damaged or of another leg. If `known` is not null, it has the reports of
// earlier calls, which are not read again, and gets the reports of this call.
LegReports kept_statistics(system::Files& files, const Folder& folder, const LeagueState& state,
                           KnownReports* known = nullptr);

// Returns the records of the legs that count and lack a report or facts.
std::vector<std::string> uncounted_records(const LeagueState& state, const LegReports& reports,
                                           const FactsOfLegs& facts);

// Like kept_statistics(), but simulates legs without a kept report again, and writes no file.
// Errors are those of statistics::count_record().
Result<LegReports> all_statistics(system::Files& files, const Folder& folder,
                                  const LeagueState& state);

// Returns the team whose robots kept out the greatest share of the shots on their goal, for the
// bests of the league. Returns nothing if no team has faced least_shots shots.
inline constexpr int least_shots = 10;
std::optional<Best> best_goalkeeper(const Overview& overview, const LegReports& reports);

// Returns the part of the league's page with the numbers of each team over all its legs; "" if no
// leg has been counted.
std::string statistics_html(const Overview& overview, const LegReports& reports);

// Returns the part of a team's page with its numbers, as blue and as yellow, and the kinds of goals
// against the team.
std::string team_statistics_html(const Overview& overview, const LegReports& reports, int team);

// Returns statistics.json, statistics.csv and goals.csv. The files refer to the reports, which must
// outlive them.
FileMakers statistics_exports(const LegReports& reports);

}  // namespace mirocup::league
