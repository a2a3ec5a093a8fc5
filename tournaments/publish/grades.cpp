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

Result<Marks> read_marks(std::string_view text, const std::string& path) {
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

}  // namespace

Result<SiteFile> grades(const Overview& o, std::string_view drills_csv, const std::string& path) {
  const auto marks = read_marks(drills_csv, path);
  if (!marks) return tl::unexpected(marks.error());
  std::vector<std::string> cells{"rank", "team", "points", "strength"};
  cells.insert(cells.end(), marks->drills.begin(), marks->drills.end());
  std::string text = system::csv_line(cells);
  bool any_is_known = false;
  for (std::size_t i = 0; i < o.table.size(); ++i) {
    const TableRow& row = o.table[i];
    const std::string& team = o.state.name(row.team);
    cells = {std::to_string(i + 1), team, std::to_string(row.points),
             std::to_string(std::lround(o.ratings.strengths[row.team].value))};
    const auto of_team = marks->of_team.find(team);
    any_is_known = any_is_known || of_team != marks->of_team.end();
    for (const std::string& drill : marks->drills) {
      const bool has_mark = of_team != marks->of_team.end() && of_team->second.count(drill) != 0;
      cells.push_back(has_mark ? of_team->second.at(drill) : "");
    }
    text += system::csv_line(cells);
  }
  if (!any_is_known) return fail(Errc::input, path + ": it has no team of this league");
  return SiteFile{"grades.csv", text};
}

}  // namespace mirocup::league
