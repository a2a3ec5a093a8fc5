// SPDX-License-Identifier: MIT
#include "tournaments/publish/league_statistics.hpp"

#include "record/json_reader.hpp"
#include "record/statistics/statistics_json.hpp"
#include "system/text.hpp"
#include "tournaments/publish/page_values.hpp"
#include "tournaments/publish/replay_pages.hpp"
#include "tournaments/publish/team_page.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <set>
#include <utility>

namespace mirocup::league {

namespace {

using statistics::GoalOrigin;
using statistics::LegReport;
using statistics::TeamStatistics;
using statistics::TeamTotals;

constexpr std::size_t most_goals_unfolded = 60;
constexpr double lead_in_s = 3.0;  // a link to a goal shows what came before it

Result<LegReport> kept_report(system::Files& files, const Folder& folder,
                              const std::string& record) {
  const std::string path = folder.site() + "/" + statistics_file_of(record);
  MIROCUP_TRY(const auto text, files.read(path, {.max_size = system::size_limit::note}));
  return statistics::parse_leg_report(text, path);
}

// A leg that counts and was played.
struct CountedLeg {
  std::string name;  // "r3-f1 leg 2"
  const PlayedLeg* played;
};

std::vector<CountedLeg> counted_legs(const LeagueState& state) {
  std::vector<CountedLeg> legs;
  for (const FixtureState& f : state.fixtures) {
    if (!f.fixture.has_both() || f.is_annulled) continue;
    for (int leg = 1; leg <= f.needed(); ++leg) {
      const PlayedLeg* played = f.legs[leg - 1].played.get();
      if (played == nullptr || played->record.empty()) continue;
      legs.push_back({f.fixture.id() + " leg " + std::to_string(leg), played});
    }
  }
  return legs;
}

// The report with the names that the league has for it, or nothing if it is of another leg.
std::optional<LegReport> named(Result<LegReport> report, const CountedLeg& leg) {
  if (!report || report->differs) return std::nullopt;
  if (to_hex(report->state_hash) != leg.played->state_hash) return std::nullopt;
  report->leg = leg.name;
  report->record = leg.played->record;
  return *std::move(report);
}

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

// The team's colour in a leg; nothing if it did not play in it.
std::optional<Team> colour_of(const LegReport& leg, const std::string& name) {
  for (const Team team : both_teams) {
    if (leg.names[index_of(team)] == name) return team;
  }
  return std::nullopt;
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

Json goals_against(const LeagueState& state, const LegReports& reports, const std::string& name) {
  Json goals = Json::array();
  for (const LegReport& leg : reports) {
    const auto colour = colour_of(leg, name);
    const std::string page = page_of_record(state, "../", leg.record);
    for (const statistics::Goal& goal : leg.statistics.goals) {
      if (!colour || goal.team == *colour) continue;
      const double at = std::max(0.0, goal.tick * leg.control_period - lead_in_s);
      goals.push_back({{"leg", leg.leg},
                       {"by", state.shown_name_of(leg.names[index_of(goal.team)])},
                       {"kind", in_words(goal.origin)},
                       {"restart", in_words(goal.restart) + ": " + in_words(goal.restart_law)},
                       {"after", system::formatted("%.1f s", goal.since_restart)},
                       {"loss", loss_in_words(goal.loss, goal, leg.control_period)},
                       {"tick", goal.tick},
                       {"page", page.empty() ? "" : page + system::formatted("#t=%.2f", at)}});
    }
  }
  return goals;
}

}  // namespace

std::string statistics_file_of(const std::string& record) {
  return "statistics/" + std::filesystem::path(record).stem().string() + ".json";
}

std::optional<std::string> counted_hash(system::Files& files, const Folder& folder,
                                        const std::string& record) {
  const auto report = kept_report(files, folder, record);
  return report ? std::optional(to_hex(report->state_hash)) : std::nullopt;
}

LegReports kept_statistics(system::Files& files, const Folder& folder, const LeagueState& state,
                           KnownReports* known) {
  KnownReports none;
  if (known == nullptr) known = &none;
  LegReports reports;
  for (const CountedLeg& leg : counted_legs(state)) {
    const std::string& record = leg.played->record;
    auto found = known->find(record);
    if (found == known->end()) {
      auto report = kept_report(files, folder, record);
      if (!report) continue;
      found = known->emplace(record, *std::move(report)).first;
    }
    if (auto report = named(found->second, leg)) reports.push_back(*std::move(report));
  }
  return reports;
}

std::vector<std::string> uncounted_records(const LeagueState& state, const LegReports& reports,
                                           const FactsOfLegs& facts) {
  std::set<std::string> counted;
  for (const LegReport& report : reports) counted.insert(report.record);
  std::vector<std::string> records;
  for (const CountedLeg& leg : counted_legs(state)) {
    const std::string& record = leg.played->record;
    if (!counted.contains(record) || !facts.contains(record)) records.push_back(record);
  }
  return records;
}

Result<LegReports> all_statistics(system::Files& files, const Folder& folder,
                                  const LeagueState& state) {
  const std::vector<CountedLeg> legs = counted_legs(state);
  LegReports reports(legs.size());
  std::vector<std::string> missing;
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < legs.size(); ++i) {
    if (auto report = named(kept_report(files, folder, legs[i].played->record), legs[i])) {
      reports[i] = *std::move(report);
    } else {
      missing.push_back(folder.path + "/" + legs[i].played->record);
      places.push_back(i);
    }
  }
  MIROCUP_TRY(auto counted, statistics::count_records(files, missing));
  for (std::size_t i = 0; i < places.size(); ++i) {
    const CountedLeg& leg = legs[places[i]];
    auto report = named(std::move(counted[i]), leg);
    if (!report) {
      return fail(Errc::damaged, missing[i] + ": it is not the leg that the journal has as " +
                                     leg.name + " (state hash, or the result of its replay)");
    }
    reports[places[i]] = *std::move(report);
  }
  return reports;
}

std::optional<Best> best_goalkeeper(const Overview& o, const LegReports& reports) {
  const std::vector<TeamTotals> totals = statistics::totals_of(reports);
  std::optional<Best> best;
  double highest = -1.0;
  for (const TeamTotals& t : totals) {
    const auto team = o.state.find_team(t.name);
    const int shots = t.against.shots_on_goal;
    if (!team || shots < least_shots) continue;
    const double share = static_cast<double>(t.own.saves) / shots;
    if (share <= highest) continue;
    highest = share;
    best = Best{
        "Best goalkeeper", statistics::percent(share), o.state.shown_name(*team),
        "saved " + std::to_string(t.own.saves) + " of " + std::to_string(shots) + " shots on goal",
        team_page_of(t.name)};
  }
  return best;
}

std::string statistics_html(const Overview& o, const LegReports& reports) {
  if (reports.empty()) return "";
  const std::vector<TeamTotals> totals = statistics::totals_of(reports);
  const auto of = [&](int team) {
    return std::find_if(totals.begin(), totals.end(),
                        [&](const TeamTotals& t) { return t.name == o.state.name(team); });
  };
  Json numbers = numbers_table("Team");
  Json kinds = kinds_table("Team");
  for (const TableRow& row : o.table) {
    const auto found = of(row.team);
    if (found == totals.end()) continue;
    const std::string name = o.state.shown_name(row.team);
    numbers["rows"].push_back(numbers_row(name, *found, team_page_of(found->name)));
    kinds["rows"].push_back(kinds_row(name, found->own));
  }
  return filled_page("statistics.html",
                     {{"numbers", numbers}, {"kinds", kinds}, {"legs", reports.size()}});
}

std::string team_statistics_html(const Overview& o, const LegReports& reports, int team) {
  const std::string& name = o.state.name(team);
  TeamTotals all;
  match::ByTeam<TeamTotals> by_colour;
  for (const LegReport& leg : reports) {
    const auto colour = colour_of(leg, name);
    if (!colour) continue;
    all.add(leg.statistics, *colour);
    by_colour[index_of(*colour)].add(leg.statistics, *colour);
  }
  if (all.legs == 0) return "";
  Json numbers = numbers_table("");
  numbers["rows"] = {numbers_row("All", all), numbers_row("As blue", by_colour[0]),
                     numbers_row("As yellow", by_colour[1])};
  Json kinds = kinds_table("");
  kinds["rows"] = {kinds_row("For it", all.own), kinds_row("Against it", all.against)};
  const Json goals = goals_against(o.state, reports, name);
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
