// SPDX-License-Identifier: MIT
#include "tournaments/publish/grades.hpp"

#include "record/json_reader.hpp"
#include "system/csv.hpp"
#include "system/number_of.hpp"
#include "system/text.hpp"
#include "tournaments/league/headings.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>

namespace mirocup::league {

namespace {

// The scores by team and drill, and the drills in the order in which they came.
struct Marks {
  std::map<std::string, std::map<std::string, std::string>> of_team;
  std::vector<std::string> drills;

  // Returns "" if the team has no score in the drill.
  std::string score(const std::string& team, const std::string& drill) const {
    const auto scores = of_team.find(team);
    if (scores == of_team.end() || !scores->second.contains(drill)) return "";
    return scores->second.at(drill);
  }
};

std::string with_digits(double value, int digits) {
  return system::formatted("%.*f", digits, value);
}

Result<Marks> read_drill_marks(std::string_view text, const std::string& path) {
  constexpr std::size_t titles = 3;
  const auto is_titles = [](const std::vector<std::string>& cells) {
    return cells.size() >= titles && cells[0] == "team" && cells[2] == "score" &&
           (cells[1] == "drill" || cells[1] == "sheet");
  };
  const auto table = system::read_csv(text);
  if (!table) return fail(Errc::input, path + ": " + table.error().what);
  if (table->rows.empty() || !is_titles(table->rows[0].cells))
    return fail(Errc::input, path + ": it is not what mirocup drill or grade --csv prints");
  Marks marks;
  // Of several outputs, each with an "all" of its own drills; the output of a sheet has none.
  bool is_joined = table->rows[0].cells[1] == "sheet";
  std::set<std::string> drills;
  for (std::size_t i = 1; i < table->rows.size(); ++i) {
    const std::vector<std::string>& cells = table->rows[i].cells;
    const std::string at = path + ": line " + std::to_string(table->rows[i].line);
    if (cells.size() < titles) return fail(Errc::input, at + " has no score");
    if (is_titles(cells)) {
      is_joined = true;
      continue;
    }
    auto& scores = marks.of_team[cells[0]];
    if (scores.contains(cells[1]) && cells[1] != "all")
      return fail(Errc::input, at + ": " + cells[0] + " has a score in " + cells[1] + " already");
    is_joined = is_joined || scores.contains(cells[1]);
    scores[cells[1]] = cells[2];
    if (cells[1] != "all" && drills.insert(cells[1]).second) marks.drills.push_back(cells[1]);
  }
  for (auto& [team, scores] : marks.of_team) {
    if (!is_joined) break;
    scores.erase("all");
    double sum = 0.0;
    for (const auto& [drill, score] : scores) sum += system::number_of<double>(score).value_or(0.0);
    if (scores.size() == drills.size())
      scores["all"] = with_digits(sum / static_cast<double>(drills.size()), 1);
  }
  marks.drills.emplace_back("all");
  return marks;
}

// Returns the house teams that a team has beaten, in the order of the league.
std::string house_teams_beaten(const Overview& o, int team) {
  std::string names;
  for (int other = 0; other < static_cast<int>(o.state.file.teams.size()); ++other) {
    if (other == team || !o.state.file.teams[other].is_house()) continue;
    int ahead = 0;
    for (const LegView& leg : o.legs) {
      if (!leg.is_of(other) || !leg.counts_for(team)) continue;
      const char letter = leg.letter(team);
      ahead += letter == 'W' ? 1 : letter == 'L' ? -1 : 0;
    }
    if (ahead > 0) names += (names.empty() ? "" : " ") + o.state.name(other);
  }
  return names;
}

const char* state_of(const Overview& o, std::optional<int> team) {
  if (!team) return "not in the league";
  const TeamState& state = o.state.teams[*team];
  if (state.status == TeamStatus::withdrawn) return "withdrawn";
  if (state.status == TeamStatus::paused) return "paused";
  return state.entry > 0 ? "plays" : "no entry";
}

// A team with what is graded.
struct Graded {
  std::string name;
  std::optional<int> team;  // in the league
  TableRow row;
  std::string rank;
  People who;

  std::size_t students() const { return std::max<std::size_t>(who.members.size(), 1); }

  // Returns what a further column says: of all, or of one of the members.
  std::string more(const std::string& column, std::optional<std::size_t> member) const {
    for (const auto& [head, value] : who.more) {
      if (head != column) continue;
      const std::vector<std::string> parts = parts_of(value);
      return member && parts.size() == students() ? parts[*member] : value;
    }
    return "";
  }
};

std::vector<Graded> all_graded(const Overview& o, const PeopleOfTeams& people) {
  std::vector<Graded> all;
  for (const bool is_out : {false, true}) {
    for (const TableRow& row : o.table) {
      const bool is_last = !o.state.file.format.is_open_ended() &&
                           o.state.teams[row.team].status == TeamStatus::withdrawn;
      if (is_last != is_out) continue;
      Graded one{
          .name = o.state.name(row.team), .team = row.team, .row = row, .rank = {}, .who = {}};
      if (row.rank > 0) one.rank = std::to_string(all.size() + 1);
      if (const auto known = people.find(one.name); known != people.end()) one.who = known->second;
      all.push_back(std::move(one));
    }
  }
  for (const auto& [name, who] : people) {
    if (!o.state.find_team(name))
      all.push_back({.name = name, .team = std::nullopt, .row = {}, .rank = {}, .who = who});
  }
  return all;
}

// A row for each student, for a program that knows students by mail and number.
Result<std::string> students(const Overview& o, const std::vector<Graded>& all,
                             const std::vector<std::string>& columns, GradesLayout layout,
                             const MarksOfTeams& marks, const Marks& drills) {
  const std::string mail = heading_of("mail", columns);
  const std::string number = heading_of("number", columns);
  if (mail.empty() && number.empty()) {
    return fail(Errc::input,
                "these columns need the mail or the number of each student: give the class list a "
                "column \"mail\" or \"number\" (league team DIR --csv FILE)");
  }
  std::string text = layout == GradesLayout::moodle
                         ? system::csv_line({"Email address", "ID number", o.state.file.title})
                         : system::csv_line({"Name", "Email", "SID", "Total Score", "Max Points"});
  for (const Graded& one : all) {
    const int win = o.state.file.points.win;
    const double best = static_cast<double>(one.row.played) * win;
    // A team without a leg that counts has no grade.
    const std::string score =
        !marks.empty()
            ? (one.team && marks[*one.team] ? with_digits(marks[*one.team]->value, 2) : "")
        : !drills.of_team.empty() ? drills.score(one.name, "all")
        : one.row.played == 0
            ? ""
            : with_digits(best > 0.0 ? 100.0 * static_cast<double>(one.row.points) / best : 0.0, 2);
    std::size_t count = one.students();
    for (const std::string& column : {mail, number}) {
      const std::string cell = one.more(column, std::nullopt);
      const std::size_t known = cell.empty() ? 0 : parts_of(cell).size();
      if (one.who.members.empty()) count = std::max(count, known);
      if (known != 0 && known != count) {
        return fail(Errc::input, one.name + " has " + std::to_string(one.who.members.size()) +
                                     " members and " + std::to_string(known) + " in the column \"" +
                                     column + "\": put ; between the values of two members");
      }
    }
    for (std::size_t i = 0; i < count; ++i) {
      const auto part = [&](const std::string& column) {
        const std::string cell = one.more(column, std::nullopt);
        return cell.empty() ? cell : parts_of(cell)[i];
      };
      const std::string who = i < one.who.members.size() ? one.who.members[i] : "";
      if (part(mail).empty() && part(number).empty()) {
        if (who.empty()) continue;
        return fail(Errc::input, one.name + ": neither mail nor number of " + who + " is known");
      }
      text += layout == GradesLayout::moodle
                  ? system::csv_line({part(mail), part(number), score})
                  : system::csv_line({who, part(mail), part(number), score, "100"});
    }
  }
  return text;
}

}  // namespace

Result<Scale> read_scale(std::string_view text, const std::string& path) {
  return record::read_json<Scale>(text, path, Errc::input, [](const record::JsonReader& json) {
    Scale scale;
    std::optional<double> below;
    for (const record::JsonReader& element : json.elements(2, 20)) {
      element.expect_object({"mark", "beats"});
      const double mark = element.at("mark").number(-1000.0, 1000.0);
      std::string beats;
      element.read_if_present("beats", beats);
      if (!beats.empty()) {
        scale.steps.push_back({mark, beats});
      } else if (scale.steps.empty() && !below) {
        below = mark;
      } else {
        element.complain("only the first element may lack \"beats\"");
      }
    }
    if (scale.steps.size() < 2) json.complain("two house teams at least are needed");
    if (!scale.steps.empty()) scale.below = below.value_or(scale.steps[0].mark);
    return scale;
  });
}

Result<SheetScores> scores_of_sheets(std::string_view text, const std::string& path) {
  MIROCUP_TRY(auto marks, read_drill_marks(text, path));
  for (auto& [team, scores] : marks.of_team) scores.erase("all");
  return std::move(marks.of_team);
}

Result<SiteFile> grades(const Overview& o, const PeopleOfTeams& people, std::string_view drills_csv,
                        const std::string& path, GradesLayout layout,
                        const MarksOfTeams& of_scale) {
  MIROCUP_TRY(const auto marks,
              path.empty() ? Result<Marks>(Marks{}) : read_drill_marks(drills_csv, path));
  const std::vector<Graded> all = all_graded(o, people);
  std::vector<std::string> columns;
  for (const Graded& one : all) {
    for (const auto& [column, value] : one.who.more) {
      if (std::ranges::find(columns, column) == columns.end()) columns.push_back(column);
    }
  }
  const bool any_is_known = path.empty() || std::ranges::any_of(all, [&](const auto& one) {
                              return marks.of_team.contains(one.name);
                            });
  if (!any_is_known) return fail(Errc::input, path + ": it has no team of this league");
  if (layout == GradesLayout::moodle || layout == GradesLayout::gradescope) {
    MIROCUP_TRY(auto text, students(o, all, columns, layout, of_scale, marks));
    return SiteFile{layout == GradesLayout::moodle ? "moodle.csv" : "gradescope.csv",
                    std::move(text)};
  }
  const bool by_member = layout == GradesLayout::members;
  std::vector<std::string> cells{"rank",           "team",
                                 "points",         "played",
                                 "strength",       "strength_low",
                                 "strength_high",  "house_beaten",
                                 "display",        by_member ? "member" : "members",
                                 "points_per_leg", "state",
                                 "entry"};
  cells.insert(cells.end(), columns.begin(), columns.end());
  cells.insert(cells.end(), marks.drills.begin(), marks.drills.end());
  if (!of_scale.empty())
    cells.insert(cells.end(), {"mark", "mark_low", "mark_high", "mark_decided", "mark_legs"});
  std::string text = system::csv_line(cells);
  for (const Graded& one : all) {
    const auto strength = [&](double Strength::*part) {
      return one.rank.empty() ? ""
                              : std::to_string(std::lround(o.ratings.strengths[*one.team].*part));
    };
    const int entry = one.team ? o.state.teams[*one.team].entry : 0;
    const double a_leg =
        one.row.played > 0 ? static_cast<double>(one.row.points) / one.row.played : 0.0;
    for (std::size_t i = 0; i < (by_member ? one.students() : 1); ++i) {
      const std::optional<std::size_t> member = by_member ? std::optional(i) : std::nullopt;
      cells = {one.rank,
               one.name,
               std::to_string(one.row.points),
               std::to_string(one.row.played),
               strength(&Strength::value),
               strength(&Strength::low),
               strength(&Strength::high),
               one.team ? house_teams_beaten(o, *one.team) : "",
               one.who.display,
               !by_member                ? system::joined(one.who.members, "; ")
               : one.who.members.empty() ? ""
                                         : one.who.members[i],
               one.rank.empty() && one.team ? "" : with_digits(a_leg, 3),
               state_of(o, one.team),
               entry > 0 ? std::to_string(entry) : ""};
      for (const std::string& column : columns) cells.push_back(one.more(column, member));
      for (const std::string& drill : marks.drills) cells.push_back(marks.score(one.name, drill));
      if (!of_scale.empty()) {
        const auto mark = one.team ? of_scale[*one.team] : std::nullopt;
        for (double ScaleMark::*part : {&ScaleMark::value, &ScaleMark::low, &ScaleMark::high})
          cells.push_back(mark ? with_digits((*mark).*part, 2) : "");
        cells.push_back(!mark ? "" : mark->is_decided ? "yes" : "no");
        cells.push_back(mark ? std::to_string(mark->legs) : "");
      }
      text += system::csv_line(cells);
    }
  }
  return SiteFile{"grades.csv", text};
}

}  // namespace mirocup::league
