// SPDX-License-Identifier: MIT
#include "tournaments/publish/grades.hpp"

#include "system/csv.hpp"
#include "system/printable.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace mirocup::league {

namespace {

constexpr std::string_view titles = "team,drill,score,";  // the first columns of the drills' file

// The next line of a text, which then begins behind it.
std::string_view take_line(std::string_view& text) {
  const std::size_t end = std::min(text.find('\n'), text.size());
  std::string_view line = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
  return line;
}

// The scores by team and drill, and the drills in the order in which they came.
struct Marks {
  std::map<std::string, std::map<std::string, std::string>> of_team;
  std::vector<std::string> drills;
};

Result<Marks> read_drill_marks(std::string_view text, const std::string& path) {
  if (!text.starts_with(titles)) {
    return fail(Errc::input, path + ": it is not what mirocup drill --csv prints");
  }
  Marks marks;
  take_line(text);
  for (int number = 2; !text.empty(); ++number) {
    const std::vector<std::string> cells = system::csv_cells(take_line(text));
    if (cells.size() < 3) {
      return fail(Errc::input, path + ": line " + std::to_string(number) + " has no score");
    }
    marks.of_team[cells[0]][cells[1]] = cells[2];
    const bool is_known =
        std::find(marks.drills.begin(), marks.drills.end(), cells[1]) != marks.drills.end();
    if (!is_known) marks.drills.push_back(cells[1]);
  }
  return marks;
}

// Returns the house teams that a team has beaten, in the order of the league.
std::string house_teams_beaten(const Overview& o, int team) {
  std::string names;
  for (int other = 0; other < static_cast<int>(o.state.file.teams.size()); ++other) {
    if (other == team || !o.state.file.teams[other].is_house()) continue;
    int ahead = 0;
    for (const LegView& leg : o.legs) {
      if (!leg.is_of(team) || !leg.is_of(other) || leg.played == nullptr || leg.is_annulled)
        continue;
      const LegResult& result = leg.played->result;
      if (leg.home == team ? !result.counts_for_home : !result.counts_for_away) continue;
      const char letter = leg.letter(team);
      ahead += letter == 'W' ? 1 : letter == 'L' ? -1 : 0;
    }
    if (ahead > 0) names += (names.empty() ? "" : " ") + o.state.name(other);
  }
  return names;
}

std::string joined(const std::vector<std::string>& members) {
  std::string text;
  for (const std::string& member : members) text += (text.empty() ? "" : "; ") + member;
  return text;
}

}  // namespace

Result<SiteFile> grades(const Overview& o, const PeopleOfTeams& people, std::string_view drills_csv,
                        const std::string& path) {
  MIROCUP_TRY(const auto marks,
              path.empty() ? Result<Marks>(Marks{}) : read_drill_marks(drills_csv, path));
  std::vector<std::string> cells{"rank",     "team",         "points",        "played",
                                 "strength", "strength_low", "strength_high", "house_beaten",
                                 "display",  "members"};
  cells.insert(cells.end(), marks.drills.begin(), marks.drills.end());
  std::string text = system::csv_line(cells);
  bool any_is_known = path.empty();
  for (std::size_t i = 0; i < o.table.size(); ++i) {
    const TableRow& row = o.table[i];
    const std::string& team = o.state.name(row.team);
    const Strength& strength = o.ratings.strengths[row.team];
    const auto known = people.find(team);
    const People who = known != people.end() ? known->second : People();
    cells = {std::to_string(i + 1),
             team,
             std::to_string(row.points),
             std::to_string(row.played),
             std::to_string(std::lround(strength.value)),
             std::to_string(std::lround(strength.low)),
             std::to_string(std::lround(strength.high)),
             house_teams_beaten(o, row.team),
             who.display,
             joined(who.members)};
    const auto of_team = marks.of_team.find(team);
    any_is_known = any_is_known || of_team != marks.of_team.end();
    for (const std::string& drill : marks.drills) {
      const bool has_mark = of_team != marks.of_team.end() && of_team->second.count(drill) != 0;
      cells.push_back(has_mark ? of_team->second.at(drill) : "");
    }
    text += system::csv_line(cells);
  }
  if (!any_is_known) return fail(Errc::input, path + ": it has no team of this league");
  return SiteFile{"grades.csv", text};
}

}  // namespace mirocup::league
