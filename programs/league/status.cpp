// SPDX-License-Identifier: MIT
//
// The subcommands that say how a league stands: status, health, decisions, and stats, which
// `mirocup stats` starts for a league.
#include "programs/league/commands.hpp"
#include "programs/league/publishing.hpp"
#include "record/statistics/report.hpp"
#include "tournaments/league/book.hpp"
#include "tournaments/league/decisions.hpp"
#include "tournaments/league/health.hpp"
#include "tournaments/league/roster.hpp"
#include "tournaments/league/sheets.hpp"
#include "tournaments/publish/exports.hpp"
#include "tournaments/publish/league_statistics.hpp"
#include "tournaments/publish/site.hpp"

namespace mirocup::league {

namespace {

struct StatusOptions : LeagueOptions {
  bool entries = false;
  std::string sheet;  // whose deadline holds; "": none
  bool json = false;
};

void print_row(const LeagueFile& file, const RosterRow& row) {
  std::cout << row.team;
  if (!row.people.display.empty()) std::cout << " \"" << row.people.display << '"';
  std::cout << ": " << row.state();
  if (!row.handed_in.empty()) std::cout << ", " << shown_time(file, row.handed_in);
  std::cout << system::printable(row.standing()) << '\n';
  if (row.was_refused()) std::cout << "    " << system::printable(row.message) << '\n';
  for (const std::string& note : row.notes) std::cout << "    " << system::printable(note) << '\n';
  for (const std::string& other : row.same_as)
    std::cout << "    the same file as " << other << '\n';
}

void print_last_leg(const LeagueFile& file, const std::string& at) {
  if (!at.empty()) std::cout << "the last leg was played at " << shown_time(file, at) << '\n';
}

// Adds to the JSON of each team but the house teams the number of the last accepted entry that was
// handed in by the deadline, or null.
void add_by_deadline(Json& teams, const SheetDeadline& deadline, const HandIns& hand_ins) {
  for (Json& row : teams) {
    const std::string team = record::text_in(row, "team");
    if (row["house"] == false) row["by_deadline"] = Json();
    for (const auto& [number, handed] : hand_ins.of_team(team)) {
      const bool is_in_time = utc_text(handed.at) <= deadline.of(team);
      if (is_in_time && handed.state == HandInState::accepted) row["by_deadline"] = number;
    }
  }
}

Result<void> print_roster(system::Files& files, const LeagueStore& store,
                          const StatusOptions& options) {
  MIROCUP_TRY(const auto book, Book::open(files, store.folder()));
  MIROCUP_TRY(const auto rows, roster(files, store, book.hand_ins()));
  const LeagueState& state = store.state();
  const std::string last = last_leg_at(store.journal());
  if (options.json) {
    Json teams = roster_json(rows);
    MIROCUP_TRY(const auto sheets, read_sheet_deadlines(files, store.folder(), state.file));
    const auto sheet = sheets.find(options.sheet);
    if (sheet != sheets.end()) add_by_deadline(teams, sheet->second, book.hand_ins());
    print_json({{"title", state.file.title},
                {"played", state.played()},
                {"legs", state.legs()},
                {"last_leg_at", record::or_null(last)},
                {"teams", teams}});
    return {};
  }
  for (const RosterRow& row : rows) print_row(state.file, row);
  print_last_leg(state.file, last);
  return {};
}

void print_table(const LeagueStore& store) {
  const LeagueState& state = store.state();
  std::cout << system::printable(state.file.title) << ": " << state.played() << " of "
            << state.legs() << " legs played\n"
            << table_text(state);
  for (std::size_t i = 0; i < state.teams.size(); ++i) {
    const TeamState& team = state.teams[i];
    if (team.status == TeamStatus::playing) continue;
    std::cout << state.file.teams[i].name
              << (team.status == TeamStatus::paused ? " is paused: " : " has withdrawn: ")
              << system::printable(team.why) << '\n';
  }
  print_last_leg(state.file, last_leg_at(store.journal()));
  std::cout << "disk: " << in_words(disk_use(store.folder())) << '\n';
}

Result<int> run_status(system::Files& files, const LeagueStore& store,
                       const StatusOptions& options) {
  MIROCUP_TRY_VOID(say_gaps(files, store));
  const LeagueState& state = store.state();
  if (options.entries) {
    MIROCUP_TRY_VOID(print_roster(files, store, options));
  } else if (options.json) {
    Json json = table_json(overview(state));
    json["disk"] = disk_json(disk_use(store.folder()));
    print_json(json);
  } else {
    print_table(store);
  }
  return state.played() == state.legs() ? exit_yes : exit_no;
}

struct JsonOptions : LeagueOptions {
  bool json = false;
};

// Teams that have left need nobody.
std::vector<std::string> told_of(const RosterRow& row) {
  return row.status == TeamStatus::withdrawn ? std::vector<std::string>() : row.told();
}

Result<int> run_health(system::Files& files, const LeagueStore& store, const JsonOptions& options) {
  MIROCUP_TRY(const auto book, Book::open(files, store.folder()));
  MIROCUP_TRY(const auto h, health(files, store, book.hand_ins(), system::now_s()));
  MIROCUP_TRY(const auto rows, roster(files, store, book.hand_ins()));
  const DiskUse use = disk_use(store.folder());
  const LeagueFile& file = store.state().file;
  const int result = h.problems.empty() ? exit_yes : exit_no;
  if (options.json) {
    Json teams = Json::array();
    for (const RosterRow& row : rows)
      if (const auto told = told_of(row); !told.empty())
        teams.push_back({{"team", row.team}, {"told", told}});
    const Json night{{"number", h.night}, {"at", h.night_at}};
    print_json({{"title", file.title},
                {"needs_person", !h.problems.empty()},
                {"problems", h.problems},
                {"teams", teams},
                {"night", h.night > 0 ? night : Json()},
                {"playing", h.is_playing},
                {"open_legs", h.open_legs},
                {"hand_ins", {{"waiting", h.waiting}, {"longest_s", h.waits_s}}},
                {"disk", disk_json(use)}});
    return result;
  }
  std::cout << system::printable(file.title) << ": ";
  if (h.night == 0) std::cout << "no night yet";
  if (h.night > 0) std::cout << "night " << h.night << " began at " << shown_time(file, h.night_at);
  std::cout << (h.is_playing ? ", the league is being played" : "")
            << "; legs that are not decided: " << h.open_legs
            << "\nhand-ins that wait for their checks: " << h.waiting << "\ndisk: " << in_words(use)
            << '\n';
  for (const RosterRow& row : rows)
    for (const std::string& told : told_of(row))
      std::cout << "to look at: " << row.team << ": " << system::printable(told) << '\n';
  for (const std::string& problem : h.problems)
    std::cout << "for you: " << system::printable(problem) << '\n';
  return result;
}

Result<int> run_decisions(system::Files& files, const LeagueStore& store,
                          const JsonOptions& options) {
  MIROCUP_TRY_VOID(say_gaps(files, store));
  const LeagueState& state = store.state();
  if (options.json) {
    std::cout << decisions_json(state) << '\n';
    return exit_yes;
  }
  for (const DecisionView& d : decision_views(state)) {
    const auto& [why, by, at] = d.signature;
    std::cout << d.number << "  " << shown_time(state.file, at) << "  "
              << (by.empty() ? "-" : system::printable(by)) << "  " << system::printable(d.what)
              << "  \"" << system::printable(why) << '"'
              << (d.undoing.empty() ? "" : "  [" + d.undoing + "]") << '\n';
  }
  return exit_yes;
}

struct StatsOptions : LeagueOptions {
  statistics::ReportOptions report;
};

Result<int> run_stats(system::Files& files, const LeagueStore& store, const StatsOptions& options) {
  MIROCUP_TRY(const auto legs, all_statistics(files, store.folder(), store.state()));
  MIROCUP_TRY(const auto text, statistics::report(legs, options.report));
  std::cout << text;
  return exit_yes;
}

}  // namespace

void add_status(system::Commands& commands) {
  const auto [command, o] =
      add_command(commands, on_league<run_status, StatusOptions>, "status", to_play,
                  "Print the table and the state of the league (exit code 1: legs are left)",
                  {"mirocup league status spring", "mirocup league status spring --entries"});
  command.flag("--entries", o.entries,
               "Print each team's hand-ins and their answers; this does not change the exit code");
  command.flag("--json", o.json, "Print one JSON object");
  command.option("--sheet NAME", o.sheet).hidden();  // of mirocup grade
}

void add_health(system::Commands& commands) {
  const auto [command, o] = add_command(
      commands, on_league<run_health, JsonOptions>, "health", to_play,
      "Print the state of nights, hand-ins and disk (exit code 1: the league needs a person)",
      {"mirocup league health spring || mail -s spring lecturer@example.org"});
  command.flag("--json", o.json, "Print one JSON object");
}

void add_decisions(system::Commands& commands) {
  const auto [command, o] =
      add_command(commands, on_league<run_decisions, JsonOptions>, "decisions", to_rule,
                  "List the decisions: number, time, person, what and why",
                  {"mirocup league decisions spring"});
  command.flag("--json", o.json, "Print one JSON object");
}

void add_stats(system::Commands& commands) {
  const auto [command, o] =
      add_command(commands, on_league<run_stats, StatsOptions>, "stats", to_show,
                  "Print the football statistics of all legs that count",
                  {"mirocup league stats spring --csv"});
  statistics::add_options(command, o.report, "Only the legs of this team");
}

}  // namespace mirocup::league
