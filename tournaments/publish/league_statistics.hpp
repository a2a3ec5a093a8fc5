// SPDX-License-Identifier: MIT
//
// The football statistics of a league, over each leg that counts and has a record in the journal,
// its bests, such as its fastest goal, and the legs that are worth watching.
#pragma once

#include "record/statistics/report.hpp"
#include "tournaments/league/folder.hpp"
#include "tournaments/publish/leg_view.hpp"
#include "tournaments/publish/site_file.hpp"

#include <optional>
#include <string>
#include <vector>

namespace mirocup::league {

using LegReports = std::vector<statistics::LegReport>;

// Returns the reports of the legs that count, in the order of the schedule.
LegReports counted_reports(const Overview& overview);

// Returns the reports of all legs that count, from what is kept and, of the other legs, by
// simulating them again; writes no file. Errors are those of statistics::count_record().
Result<LegReports> all_statistics(system::Files& files, const Folder& folder,
                                  const LeagueState& state);

// Returns a best as values of a template: {title, value, who, where, page}, such as "Fastest goal",
// "4.2 s", "Orbit, robot 1", "against Lions, round 3, leg 2". `page` is the link from the top of
// the site to the moment in the replay; "": none.
Json best(const std::string& title, const std::string& value, const std::string& who,
          const std::string& where, const std::string& page);

// Returns the bests of the league so far: fastest goal, biggest win, most goals in a leg, biggest
// upset, longest winning run, longest run without defeat, most goals of a robot, cleanest team.
Json bests_of(const Overview& overview);

// Returns the most exciting legs as leg_values(), the best first, at most one of each fixture:
// legs with changes of the lead, with a late decision, with a close score, with many goals, or
// won by the far weaker team.
Json worth_watching(const Overview& overview);

// Returns the team whose robots kept out the greatest share of the shots on their goal, as best();
// null if no team has faced many shots.
Json best_goalkeeper(const Overview& overview, const LegReports& reports);

// Returns the part of the league's page with the numbers of each team over all its legs; "" if no
// leg has been counted.
std::string statistics_html(const Overview& overview, const LegReports& reports);

// Returns the part of a team's page with its numbers, as blue and as yellow, and the kinds of goals
// against the team. `root` leads from the page to the front page: "../".
std::string team_statistics_html(const Overview& overview, int team, const std::string& root);

// Returns statistics.json, statistics.csv and goals.csv. The files refer to the reports, which must
// outlive them.
FileMakers statistics_exports(const LegReports& reports);

}  // namespace mirocup::league
