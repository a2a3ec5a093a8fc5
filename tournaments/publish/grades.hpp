// SPDX-License-Identifier: MIT
//
// The table of a league joined with the marks of drills, for a lecturer's grades.
#pragma once

#include "core/base/error.hpp"
#include "tournaments/league/people.hpp"
#include "tournaments/league/sheets.hpp"
#include "tournaments/publish/leg_view.hpp"
#include "tournaments/publish/site_file.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace mirocup::league {

enum class GradesLayout {
  teams,       // a row for each team
  members,     // a row for each member
  moodle,      // a row for each student, as Moodle's import of grades reads it
  gradescope,  // a row for each student, in the form of Gradescope's scores
};

// Returns grades.csv. It has a row for each team of the table, withdrawn teams last, then a row for
// each other team in `people`:
//   rank, team, points, played           as in table.csv; no rank for a team without a row there,
//                                        or without a leg that counts in a league that takes
//                                        entries; such a team has no strength and no score
//   strength, strength_low, strength_high  the strength, and the ends of its interval
//   house_beaten                         the house teams against which the team has won more legs
//                                        than it has lost, of the legs that count
//   display, members                     the names in teams.json; members are separated by "; ".
//                                        A row for a member has the column `member` instead
//   points_per_leg, state, entry         state: plays, no entry, paused, withdrawn, or not in the
//                                        league
// then the further columns of the class list, and the team's score in each drill and in all drills
// together. If a cell of the class list has as many parts between semicolons as the team has
// members, each member's row gets one part. `drills_csv` is the output of `mirocup drill … --csv`
// or `mirocup grade … --csv`, or several of them, read from `path`; "": there are no drills. Its
// teams are matched by their names, and a missing mark is an empty cell. For Moodle and Gradescope,
// the score of a team is that in all drills; without drills, its points in per cent of the points
// that it would have if it had won all its legs. Students are named by their mail and number,
// further columns of the class list. A team for which the list has no members, mails and numbers
// has no row. Errc::input if `drills_csv` is not such an output or names no team of the league, if
// the class list lacks both columns, mails and numbers, or if it gives a member neither a mail nor
// a number.
//
// `marks`, by team, adds the columns mark, mark_low, mark_high, mark_decided and mark_legs at the
// end; for Moodle the mark is the score. Empty: the staff has no scale.
using MarksOfTeams = std::vector<std::optional<ScaleMark>>;
Result<SiteFile> grades(const Overview& overview, const PeopleOfTeams& people,
                        std::string_view drills_csv, const std::string& path,
                        GradesLayout layout = GradesLayout::teams, const MarksOfTeams& marks = {});

// Reads the scores of all sheets from the output of `mirocup grade … --csv`, or of several joined,
// by team and by sheet. Errors: Errc::input.
Result<SheetScores> scores_of_sheets(std::string_view text, const std::string& path);

// A step of a scale as its file names it.
struct NamedStep {
  double mark = 0.0;
  std::string beats;  // a house team
};

struct Scale {
  std::vector<NamedStep> steps;  // at least two, the weakest first
  double below = 0.0;            // the mark of who is weaker than the first step
};

// Reads a scale, a JSON list: [{"mark": 5.0}, {"mark": 4.0, "beats": "chaser"}, {"mark": 1.0,
// "beats": "tactician"}]. Only the first element may lack `beats`; without such an element, who is
// weaker than the first step has the first step's mark. Errors: Errc::input.
Result<Scale> read_scale(std::string_view text, const std::string& path);

}  // namespace mirocup::league
