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

// Returns grades.csv, a line for each team of the table:
//   rank, team, points, played           as in table.csv
//   strength, strength_low, strength_high  with the ends of the interval
//   house_beaten                         the house teams against which it has won more legs than
//                                        it has lost, of those that count
//   display, members                     the names in teams.json; members are separated by "; "
// and then its score in each drill and in all of them. `drills_csv` is the output of `mirocup drill
// … --csv`, read from `path`; "" for none. A team is found by its name, and has empty cells for
// missing marks. An error is Errc::input: the text is not such an output, or names no team of the
// league.
Result<SiteFile> grades(const Overview& overview, const PeopleOfTeams& people,
                        std::string_view drills_csv, const std::string& path);

}  // namespace mirocup::league
