// SPDX-License-Identifier: MIT
#include "tournaments/publish/league_statistics.hpp"

#include "record/json_reader.hpp"
#include "record/statistics/statistics_json.hpp"
#include "system/text.hpp"
#include "tournaments/publish/page_values.hpp"
#include "tournaments/publish/site_file.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

namespace mirocup::league {

namespace {

using statistics::GoalOrigin;
using statistics::LegReport;
using statistics::TeamStatistics;
using statistics::TeamTotals;

constexpr std::size_t most_goals_unfolded = 60;
constexpr int least_shots = 10;  // on the goal of a best goalkeeper

// The name of an enumerator for people: "kick off".
std::string in_words(auto e) {
  std::string text(to_string(e));
  for (char& c : text) c = c == '_' ? ' ' : static_cast<char>(std::tolower(c));
  return text;
}

// A column of the tables of numbers.
struct Column {
  const char* head;
  std::string (*text)(const TeamTotals&);
};

constexpr std::array<Column, 11> columns{{
    {"Legs", [](const TeamTotals& t) { return std::to_string(t.legs); }},
    {"Shots", [](const TeamTotals& t) { return std::to_string(t.own.shots); }},
    {"On goal", [](const TeamTotals& t) { return std::to_string(t.own.shots_on_goal); }},
    {"Saves",
     [](const TeamTotals& t) {
       return std::to_string(t.own.saves) + " of " + std::to_string(t.against.shots_on_goal);
     }},
    {"Passes", [](const TeamTotals& t) { return std::to_string(t.own.passes); }},
    {"Interceptions", [](const TeamTotals& t) { return std::to_string(t.own.interceptions); }},
    {"Possession",
     [](const TeamTotals& t) {
       return statistics::percent(statistics::share(t.own.possession_s, t.against.possession_s));
     }},
    {"Territory",
     [](const TeamTotals& t) {
       return statistics::percent(
           statistics::share(t.own.opponent_half_s, t.against.opponent_half_s));
     }},
    {"Ball lost", [](const TeamTotals& t) { return std::to_string(t.own.all_losses()); }},
    {"Duels won",
     [](const TeamTotals& t) {
       return std::to_string(t.own.duels_won) + " of " + std::to_string(t.duels);
     }},
    {"Fouls", [](const TeamTotals& t) { return std::to_string(t.own.all_fouls()); }},
}};

Json row_of(const std::string& name, std::vector<std::string> cells, const std::string& page = "") {
  return {{"name", name}, {"page", page}, {"cells", std::move(cells)}};
}

// The values of statistics_table.html: a column for each of `columns`.
Json numbers_table(const std::string& first) {
  Json table{{"first", first}, {"rows", Json::array()}};
  for (const Column& column : columns) table["heads"].push_back(column.head);
  return table;
}

Json numbers_row(const std::string& name, const TeamTotals& totals, const std::string& page = "") {
  std::vector<std::string> cells;
  for (const Column& column : columns) cells.push_back(column.text(totals));
  return row_of(name, std::move(cells), page);
}

// The values of statistics_table.html: a column for each kind of goal.
Json kinds_table(const std::string& first) {
  Json table{{"first", first}, {"heads", {"all"}}, {"rows", Json::array()}};
  for (std::size_t i = 0; i < enum_names<GoalOrigin>.size(); ++i)
    table["heads"].push_back(in_words(static_cast<GoalOrigin>(i)));
  return table;
}

Json kinds_row(const std::string& name, const TeamStatistics& own) {
  std::vector<std::string> cells{std::to_string(own.all_goals())};
  for (const int goals : own.goals) cells.push_back(std::to_string(goals));
  return row_of(name, std::move(cells));
}

std::string fouls_in_words(const TeamStatistics& own) {
  std::string text;
  for (std::size_t i = 0; i < own.fouls.size(); ++i) {
    if (own.fouls[i] == 0) continue;
    text += (text.empty() ? "" : ", ") + in_words(static_cast<referee::Law>(i)) + " " +
            std::to_string(own.fouls[i]);
  }
  return text.empty() ? "none" : text;
}

std::string loss_in_words(const std::optional<statistics::Loss>& loss, const statistics::Goal& goal,
                          double period) {
  if (!loss) return "";
  const double before = (goal.tick - loss->tick) * period;
  const char* third = loss->third == statistics::Third::own      ? "own third"
                      : loss->third == statistics::Third::middle ? "middle"
                                                                 : "opponents' third";
  return in_words(loss->kind) + ", " + third + system::formatted(", %.1f s before", before);
}

// True if the report is of the leg that the journal has.
bool fits(const LegReport& report, const PlayedLeg& leg) {
  return !report.differs && is_of(report, leg);
}

// Adds how goals fell against a team in a leg.
void add_goals_against(const LeagueState& state, const LegView& leg, Team colour,
                       const std::string& root, Json& goals) {
  const LegReport& report = *leg.report;
  for (const statistics::Goal& goal : report.statistics.goals) {
    if (goal.team == colour) continue;
    goals.push_back({{"leg", report.leg},
                     {"by", state.shown_name_of(report.names[index_of(goal.team)])},
                     {"kind", in_words(goal.origin)},
                     {"restart", in_words(goal.restart) + ": " + in_words(goal.restart_law)},
                     {"after", system::formatted("%.1f s", goal.since_restart)},
                     {"loss", loss_in_words(goal.loss, goal, report.control_period)},
                     {"tick", goal.tick},
                     {"page", leg.page(root, goal.tick * report.control_period, 2)}});
  }
}

}  // namespace

LegReports counted_reports(const Overview& o) {
  LegReports reports;
  for (const LegView& leg : o.legs) {
    if (leg.report != nullptr) reports.push_back(*leg.report);
  }
  return reports;
}

Result<LegReports> all_statistics(system::Files& files, const Folder& folder,
                                  const LeagueState& state) {
  struct Place {
    std::size_t index;
    const PlayedLeg* played;
  };
  LegReports reports;
  std::vector<std::string> missing;
  std::vector<Place> places;  // of what is missing
  for (const FixtureState& f : state.fixtures) {
    for (int leg = 1; f.fixture.has_both() && !f.is_annulled && leg <= f.needed(); ++leg) {
      const PlayedLeg* played = f.legs[leg - 1].played.get();
      if (played == nullptr || played->record.empty()) continue;
      const LegName name{f.fixture.id(), leg};
      auto kept = kept_report(files, folder, name, played->record);
      if (!kept || !fits(*kept, *played)) {
        kept = LegReport{.record = played->record, .leg = name_in_words(name)};
        missing.push_back(folder.path + "/" + played->record);
        places.push_back({reports.size(), played});
      }
      reports.push_back(*std::move(kept));
    }
  }
  MIROCUP_TRY(auto counted, statistics::count_records(files, missing));
  for (std::size_t i = 0; i < places.size(); ++i) {
    LegReport& report = reports[places[i].index];
    if (!fits(counted[i], *places[i].played)) {
      return fail(Errc::damaged, missing[i] + ": it is not the leg that the journal has as " +
                                     report.leg + " (state hash, or the result of its replay)");
    }
    counted[i].record = std::move(report.record);
    counted[i].leg = std::move(report.leg);
    report = std::move(counted[i]);
  }
  return reports;
}

Json best_goalkeeper(const Overview& o, const LegReports& reports) {
  Json keeper;
  double highest = -1.0;
  for (const TeamTotals& t : statistics::totals_of(reports)) {
    const auto team = o.state.find_team(t.name);
    const int shots = t.against.shots_on_goal;
    const double share = static_cast<double>(t.own.saves) / std::max(shots, 1);
    if (!team || shots < least_shots || share <= highest) continue;
    highest = share;
    keeper = best(
        "Best goalkeeper", statistics::percent(share), o.state.shown_name(*team),
        "saved " + std::to_string(t.own.saves) + " of " + std::to_string(shots) + " shots on goal",
        team_page_of(t.name));
  }
  return keeper;
}

std::string statistics_html(const Overview& o, const LegReports& reports) {
  if (reports.empty()) return "";
  const std::vector<TeamTotals> totals = statistics::totals_of(reports);
  Json numbers = numbers_table("Team");
  Json kinds = kinds_table("Team");
  for (const TableRow& row : o.table) {
    const auto found = std::ranges::find(totals, o.state.name(row.team), &TeamTotals::name);
    if (found == totals.end()) continue;
    const std::string name = o.state.shown_name(row.team);
    numbers["rows"].push_back(numbers_row(name, *found, team_page_of(found->name)));
    kinds["rows"].push_back(kinds_row(name, found->own));
  }
  return filled_page("statistics.html",
                     {{"numbers", numbers}, {"kinds", kinds}, {"legs", reports.size()}});
}

std::string team_statistics_html(const Overview& o, int team, const std::string& root) {
  TeamTotals all;
  match::ByTeam<TeamTotals> by_colour;
  Json goals = Json::array();
  for (const std::size_t index : o.decided_legs[team]) {
    const LegView& leg = o.legs[index];
    if (leg.report == nullptr) continue;
    const Team colour = leg.is_blue(team) ? Team::blue : Team::yellow;
    all.add(leg.report->statistics, colour);
    by_colour[index_of(colour)].add(leg.report->statistics, colour);
    add_goals_against(o.state, leg, colour, root, goals);
  }
  if (all.legs == 0) return "";
  Json numbers = numbers_table("");
  numbers["rows"] = {numbers_row("All", all), numbers_row("As blue", by_colour[0]),
                     numbers_row("As yellow", by_colour[1])};
  Json kinds = kinds_table("");
  kinds["rows"] = {kinds_row("For it", all.own), kinds_row("Against it", all.against)};
  const bool is_folded = goals.size() > most_goals_unfolded;
  return filled_page("team_statistics.html", {{"numbers", numbers},
                                              {"kinds", kinds},
                                              {"fouls", fouls_in_words(all.own)},
                                              {"all_losses", all.own.all_losses()},
                                              {"losses",
                                               {{"own", all.own.losses[0]},
                                                {"middle", all.own.losses[1]},
                                                {"opponent", all.own.losses[2]}}},
                                              {"has_goals", !goals.empty()},
                                              {"folded", is_folded ? Json(goals.size()) : Json()},
                                              {"goals", goals}});
}

FileMakers statistics_exports(const LegReports& reports) {
  return {{"statistics.json",
           [&reports] { return record::json_text(statistics::report_json(reports)) + "\n"; }},
          {"statistics.csv", [&reports] { return statistics::numbers_csv(reports); }},
          {"goals.csv", [&reports] { return statistics::goals_csv(reports); }}};
}

}  // namespace mirocup::league
