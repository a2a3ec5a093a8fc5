// SPDX-License-Identifier: MIT
#include "tournaments/publish/site.hpp"

#include "system/text.hpp"
#include "tournaments/publish/exports.hpp"
#include "tournaments/publish/night_pages.hpp"
#include "tournaments/publish/page_values.hpp"
#include "web/design/template.hpp"

#include <cmath>

namespace mirocup::league {

std::string table_text(const LeagueState& state) {
  const bool by_strength = state.file.format.is_open_ended();
  const auto line = [&](const char* rank, const std::string& team, const std::string& numbers,
                        const std::string& goals, const std::string& points,
                        const std::string& strength, const std::string& by) {
    return system::formatted("%3s  %-20s%20s%12s%8s%*s%s%s\n", rank, team.c_str(), numbers.c_str(),
                             goals.c_str(), points.c_str(), by_strength ? 10 : 0, strength.c_str(),
                             by.empty() ? "" : "   ", by.c_str());
  };
  std::string text = line("", "Team", "legs  won drawn lost", "goals", "points",
                          by_strength ? "strength" : "", "ahead of the next by");
  const Ratings ratings = by_strength ? state.ratings() : Ratings();
  const std::vector<TableRow> table = state.table(ratings);
  for (std::size_t i = 0; i < table.size(); ++i) {
    const TableRow& row = table[i];
    const bool is_out = state.teams[row.team].status == TeamStatus::withdrawn;
    const TableRow* next = i + 1 < table.size() ? &table[i + 1] : nullptr;
    std::string by = reason_in_words(ratings, row, next);
    if (is_decided(state, ratings, row, next) == false) by += "; not decided";
    const bool has_strength = by_strength && row.rank > 0;
    text += line(row.rank > 0 ? rank_in_words(row).c_str() : "  –",  // three bytes for one column
                 state.name(row.team) + (is_out ? " (withdrawn)" : ""),
                 system::formatted("%4d%5d%6d%5d", row.played, row.won, row.drawn, row.lost),
                 std::to_string(row.goals_for) + ":" + std::to_string(row.goals_against),
                 std::to_string(row.points),
                 has_strength ? std::to_string(std::lround(ratings.strengths[row.team].value)) : "",
                 by);
  }
  if (const std::string what = unpaired_in_words(state); !what.empty()) text += what + "\n";
  return text;
}

Site::Site(SiteSource source)
    : source_(std::move(source)),
      overview_(league::overview(source_.state, source_.legs)),
      reports_(counted_reports(overview_)),
      content_{overview_,
               reports_,
               rounds_of(overview_),
               {},
               source_.night.has_value(),
               source_.playground != nullptr,
               source_.closing_page},
      makers_(makers()) {
  content_.history = strength_history(overview_, content_.rounds);
}

std::string site_style() {
  return std::string(web::design_file("design.css")) + std::string(page_file("site.css"));
}

FileMakers Site::makers() {
  FileMakers files = exports(overview_);
  files.merge(statistics_exports(reports_));
  if (source_.night) files.merge(night_pages(overview_, *source_.night));
  if (source_.playground) files[playground_name] = source_.playground;
  files["index.html"] = [this] { return front_html(content_); };
  files["style.css"] = site_style;
  files["site.js"] = [] { return std::string(page_file("site.js")); };
  for (std::size_t i = 0; i < content_.rounds.size(); ++i)
    files[content_.rounds[i].page()] = [this, i] { return round_html(content_, i); };
  if (has_crosstable(content_))
    files["crosstable.html"] = [this] { return crosstable_html(content_); };
  for (int team = 0; team < static_cast<int>(state().file.teams.size()); ++team)
    files[team_page_of(state().name(team))] = [this, team] { return team_html(content_, team); };
  return files;
}

std::vector<std::string> Site::names() const {
  std::vector<std::string> names;
  for (const auto& entry : makers_) names.push_back(entry.first);
  return names;
}

std::optional<std::string> Site::file(const std::string& name) const {
  const auto found = makers_.find(name);
  return found == makers_.end() ? std::nullopt : std::optional(found->second());
}

}  // namespace mirocup::league
