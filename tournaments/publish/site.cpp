// SPDX-License-Identifier: MIT
#include "tournaments/publish/site.hpp"

#include "tournaments/publish/bracket_svg.hpp"
#include "tournaments/publish/decision_view.hpp"
#include "tournaments/publish/exports.hpp"
#include "tournaments/publish/html.hpp"
#include "tournaments/publish/leg_view.hpp"
#include "tournaments/publish/replay_pages.hpp"
#include "tournaments/publish/team_page.hpp"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace mirocup::league {

namespace {

// A larger crosstable is of no use on a page; crosstable.json has all teams.
constexpr std::size_t max_crosstable_teams = 64;

std::string strength_text(const Strength& s) {
  return std::to_string(std::lround(s.value)) + " (" + std::to_string(std::lround(s.low)) + " … " +
         std::to_string(std::lround(s.high)) + ")";
}

std::string status_text(const TeamState& team) {
  if (team.status == TeamStatus::paused) return "(paused)";
  return team.status == TeamStatus::withdrawn ? "(withdrawn)" : "";
}

void rows_html(Html& html, const Overview& o, const std::vector<TableRow>& table,
               bool has_strength) {
  html.open_table();
  std::vector<std::string> head{"",     "Team",  "Legs",  "Won",    "Drawn",
                                "Lost", "Goals", "Diff.", "Points", "Ahead of the next by"};
  if (has_strength) {
    head.push_back("Strength (95 %)");
    head.push_back("Legs to tell");
  }
  html.row("th", head);
  for (std::size_t i = 0; i < table.size(); ++i) {
    const TableRow& row = table[i];
    const std::string& name = o.state.name(row.team);
    html.open("tr");
    html.cell_of("number", std::to_string(i + 1));
    html.open("td");
    html.link(team_page_of(name), name);
    html.raw(status_text(o.state.teams[row.team]));
    html.close("td");
    for (const int number : {row.played, row.won, row.drawn, row.lost})
      html.cell_of("number", std::to_string(number));
    html.cell_of("number",
                 std::to_string(row.goals_for) + " : " + std::to_string(row.goals_against));
    html.cell_of("number", std::to_string(row.difference()));
    html.cell_of("number", std::to_string(row.points));
    const TableRow* next = i + 1 < table.size() ? &table[i + 1] : nullptr;
    html.cell_of("small", reason_in_words(row, next));
    if (has_strength) {
      html.cell_of("small", strength_text(o.ratings.strengths[row.team]));
      html.cell_of("number", legs_to_tell_in_words(o, row, next));
    }
    html.close("tr");
  }
  html.close_table();
}

void groups_html(Html& html, const Overview& o) {
  if (o.state.file.format.kind != FormatKind::groups) return;
  const auto groups =
      deal_groups(static_cast<int>(o.state.teams.size()), o.state.file.format.groups);
  for (std::size_t group = 0; group < groups.size(); ++group) {
    std::vector<LegResult> results;
    for (const FixtureState& f : o.state.fixtures) {
      if (f.fixture.part != Part::group || f.fixture.group != static_cast<int>(group) + 1) continue;
      for (const LegState& leg : f.legs) {
        if (leg.played && !f.is_annulled) results.push_back(leg.played->result);
      }
    }
    html.cell("h2", "Group " + std::to_string(group + 1));
    rows_html(html, o, make_table(groups[group], results, o.state.file.table_rules()), false);
  }
}

void crosstable_html(Html& html, const Overview& o) {
  const std::size_t n = o.table.size();
  if (n > max_crosstable_teams) return;
  html.cell("h2", "Crosstable");
  html.cell("p", "Scores as the team on the left sees them.");
  const Meetings met = meetings(o);
  html.open_table();
  std::vector<std::string> head{"", ""};
  for (std::size_t j = 0; j < n; ++j) head.push_back(std::to_string(j + 1));
  html.row("th", head);
  for (std::size_t i = 0; i < n; ++i) {
    const int team = o.table[i].team;
    std::vector<std::string> cells{std::to_string(i + 1), o.state.name(team)};
    for (std::size_t j = 0; j < n; ++j) {
      std::string cell = i == j ? "–" : "";
      for (const std::string& score : met[team][o.table[j].team])
        cell += (cell.empty() ? "" : ", ") + score;
      cells.push_back(cell);
    }
    html.row("td", cells);
  }
  html.close_table();
}

void legs_html(Html& html, const Overview& o) {
  html.cell("h2", "Fixtures");
  html.open_table();
  html.row("th",
           {"Fixture", "Round", "Leg", "Home", "", "Away", "How it ended", "Replay", "Record"});
  for (const LegView& leg : o.legs) {
    if (leg.leg == 1) {
      html.open_with_id("tr", leg.fixture);
    } else {
      html.open("tr");
    }
    html.cell("td", leg.fixture);
    html.cell("td", leg.round);
    html.cell("td", std::to_string(leg.leg));
    html.cell("td", o.state.name(leg.home));
    html.cell("td", leg.played == nullptr ? ""
                                          : std::to_string(leg.played->result.home_goals) + " : " +
                                                std::to_string(leg.played->result.away_goals));
    html.cell("td", o.state.name(leg.away));
    html.cell_of("small", leg.played == nullptr ? "" : end_in_words(o.state, *leg.played));
    if (leg.played != nullptr && !leg.played->record.empty()) {
      html.link_cell(replay_page_of(leg.played->record), "replay");
      html.link_cell("../" + leg.played->record, "record");
    } else {
      html.cell("td", "");
      html.cell("td", "");
    }
    html.close("tr");
  }
  html.close_table();
}

// A league without decisions has no list of them.
void decisions_html(Html& html, const LeagueState& state) {
  const std::vector<DecisionView> decisions = decision_views(state);
  if (decisions.empty()) return;
  html.cell("h2", "Decisions");
  html.cell("p", "What persons decided, the latest last.");
  html.open_table();
  html.row("th", {"", "When (UTC)", "Who", "What", "Why", "Later"});
  for (const DecisionView& decision : decisions) {
    html.open("tr");
    html.cell_of("number", std::to_string(decision.number));
    html.cell("td", decision.at);
    html.cell("td", decision.by);
    html.cell_of("small", decision.what);
    html.cell_of("small", decision.why);
    html.cell_of("small", decision.undoing);
    html.close("tr");
  }
  html.close_table();
}

std::string index_html(const Overview& o, const LegReports& reports) {
  const LeagueState& state = o.state;
  Html html;
  html.begin_page(state.file.title);
  html.cell("p", std::to_string(state.played()) + " of " + std::to_string(state.legs()) +
                     " legs played.");
  const std::string bracket = bracket_svg(state);
  if (!bracket.empty()) {
    html.cell("h2", "Bracket");
    html.raw("<div class=\"wide\">\n" + bracket + "</div>\n");
  }
  html.cell("h2", "Table");
  rows_html(html, o, o.table, true);
  html.raw(
      "<p class=\"small\">Strength is fitted to all results together; 400 more means to win "
      "ten times as often as to lose. The points decide, not the strength. Legs to tell: how many "
      "legs a team and the next one would have to play against each other before their strengths "
      "differ beyond chance. As files: \n");
  for (const char* file : {"table.csv", "legs.csv", "decisions.csv", "table.json", "legs.json",
                           "decisions.json", "crosstable.json", "bracket.json"}) {
    html.link(file, file);
  }
  html.close("p");
  html.raw(statistics_html(o, reports));
  groups_html(html, o);
  decisions_html(html, state);
  crosstable_html(html, o);
  legs_html(html, o);
  html.end_page();
  return html.text();
}

}  // namespace

std::string table_text(const LeagueState& state) {
  std::ostringstream out;
  const auto line = [&out](const std::string& rank, const std::string& team,
                           const std::string& numbers, const std::string& goals,
                           const std::string& points, const std::string& by) {
    out << std::setw(3) << rank << "  " << std::left << std::setw(20) << team << std::right
        << std::setw(20) << numbers << std::setw(12) << goals << std::setw(8) << points
        << (by.empty() ? "" : "   ") << by << '\n';
  };
  line("", "Team", "legs  won drawn lost", "goals", "points", "ahead of the next by");
  const std::vector<TableRow> table = state.table();
  for (std::size_t i = 0; i < table.size(); ++i) {
    const TableRow& row = table[i];
    std::ostringstream numbers;
    numbers << std::setw(4) << row.played << std::setw(5) << row.won << std::setw(6) << row.drawn
            << std::setw(5) << row.lost;
    line(std::to_string(i + 1), state.name(row.team), numbers.str(),
         std::to_string(row.goals_for) + ":" + std::to_string(row.goals_against),
         std::to_string(row.points),
         reason_in_words(row, i + 1 < table.size() ? &table[i + 1] : nullptr));
  }
  return out.str();
}

std::vector<SiteFile> make_site(const LeagueState& state, const LegReports& reports) {
  const Overview o = overview(state);
  std::vector<SiteFile> files{{"index.html", index_html(o, reports)}};
  for (SiteFile& file : exports(o)) files.push_back(std::move(file));
  for (SiteFile& file : statistics_exports(reports)) files.push_back(std::move(file));
  for (int team = 0; team < static_cast<int>(state.file.teams.size()); ++team) {
    files.push_back({team_page_of(state.name(team)), team_html(o, reports, team)});
  }
  return files;
}

}  // namespace mirocup::league
