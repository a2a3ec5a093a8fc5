// SPDX-License-Identifier: MIT
//
// The table of a league joined with the marks of drills, for a lecturer's grades.
#pragma once

#include "core/base/error.hpp"
#include "tournaments/league/people.hpp"
#include "tournaments/publish/leg_view.hpp"
#include "tournaments/publish/site_file.hpp"

#include <string>
#include <string_view>

namespace mirocup::league {

enum class GradesLayout {
  teams,       // a row for each team
  members,     // a row for each member
  moodle,      // a row for each student, as Moodle's import of grades reads it
  gradescope,  // likewise, as Gradescope has scores
};

// Returns grades.csv, a row for each team of the table, those that have withdrawn last, and then
// for each other one in `people`:
//   rank, team, points, played           as in table.csv; no rank for a team that is not in it
//   strength, strength_low, strength_high  with the ends of the interval
//   house_beaten                         the house teams against which it has won more legs than
//                                        it has lost, of those that count
//   display, members                     the names in teams.json; members are separated by "; ",
//                                        or `member` is one of them
//   points_per_leg, state, entry         state: plays, no entry, paused, withdrawn, or not in the
//                                        league
// then the further columns of the class list, and its score in each drill and in all of them. A
// cell with as many parts between ; as the team has members has one for each of them.
// `drills_csv` is the output of `mirocup drill … --csv`, read from `path`, "" for none; a team is
// found by its name, and has empty cells where there is no mark. For Moodle and Gradescope, the
// score is the points in per cent of those of a team that wins each leg; students are named by
// their mail and number, further columns of the class list, and teams without both have no row.
// An error is Errc::input: a text that is not such an output, or one in which no team of the league
// is named; students of whom neither is known.
Result<SiteFile> grades(const Overview& overview, const PeopleOfTeams& people,
                        std::string_view drills_csv, const std::string& path,
                        GradesLayout layout = GradesLayout::teams);

}  // namespace mirocup::league
