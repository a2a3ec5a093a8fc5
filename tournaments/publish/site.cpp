// SPDX-License-Identifier: MIT
#include "tournaments/publish/site.hpp"

#include "server/web/design/template.hpp"
#include "tournaments/publish/exports.hpp"
#include "tournaments/publish/front_page.hpp"
#include "tournaments/publish/night_pages.hpp"
#include "tournaments/publish/page_values.hpp"
#include "tournaments/publish/team_page.hpp"

#include <iomanip>
#include <sstream>

namespace mirocup::league {

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

std::vector<SiteFile> make_site(const LeagueState& state, const LegReports& reports,
                                const FactsOfLegs& facts, const Night* night,
                                const std::string& feed) {
  const Overview o = overview(state, facts);
  SiteContent content{o, reports, rounds_of(o), {}};
  content.history = strength_history(o, content.rounds);
  content.has_night = night != nullptr;
  std::vector<SiteFile> files{{"index.html", front_html(content)}};
  files.push_back({"style.css", std::string(web::design_file("design.css")) +
                                    std::string(page_file("site.css"))});
  files.push_back({"site.js", std::string(page_file("site.js"))});
  for (SiteFile& file : exports(o)) files.push_back(std::move(file));
  for (SiteFile& file : statistics_exports(reports)) files.push_back(std::move(file));
  for (std::size_t i = 0; i < content.rounds.size(); ++i)
    files.push_back({content.rounds[i].page(), round_html(content, i)});
  if (std::string crosstable = crosstable_html(content); !crosstable.empty())
    files.push_back({"crosstable.html", std::move(crosstable)});
  for (int team = 0; team < static_cast<int>(state.file.teams.size()); ++team)
    files.push_back({team_page_of(state.name(team)), team_html(content, team)});
  if (night != nullptr) {
    for (SiteFile& file : night_pages(o, *night)) files.push_back(std::move(file));
  }
  if (!feed.empty()) files.push_back({"feed.xml", feed});
  return files;
}

}  // namespace mirocup::league
