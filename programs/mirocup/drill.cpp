// SPDX-License-Identifier: MIT
//
// mirocup drill: tries situations many times and gives marks.
#include "programs/mirocup/commands.hpp"
#include "programs/mirocup/tested_teams.hpp"
#include "record/team_parameters_json.hpp"
#include "system/locations.hpp"

#include <algorithm>
#include <filesystem>

namespace mirocup::app {

namespace {

struct DrillOptions : DrillTerms {
  std::string drill;                    // "list", "all", a name, or the path of a file or a folder
  std::vector<std::string> teams;       // as --blue
  std::string league;                   // a folder, whose entries are tested as well
  std::optional<int> tries;             // nothing: as each drill says
  std::vector<std::string> parameters;  // of the teams, KEY=VALUE
  std::optional<double> at_least;       // the score that is asked for; less: the answer is no
  bool csv = false;
  bool json = false;
  std::string answer;  // file for the marks, as --json prints them
};

namespace fs = std::filesystem;

Result<std::vector<std::string>> drills_in(const std::string& folder) {
  MIROCUP_TRY(const auto names, system::Disk().names_in(folder));
  std::vector<std::string> paths;
  for (const std::string& name : names) {
    if (name.ends_with(".json")) paths.push_back((fs::path(folder) / name).string());
  }
  if (paths.empty()) return fail(Errc::unavailable, folder + ": there is no drill in it");
  return paths;
}

// The files that a word of the command line stands for.
Result<std::vector<std::string>> paths_of(const std::string& word) {
  const std::string own = system::drill_folder();
  const bool is_whole_folder = word == "all" || word == "list";
  std::error_code none;
  if (is_whole_folder || fs::is_directory(word, none)) {
    return drills_in(is_whole_folder ? own : word);
  }
  system::Disk disk;
  if (word.find('/') == std::string::npos) {
    const std::string path = (fs::path(own) / (word + ".json")).string();
    if (disk.exists(path)) return std::vector<std::string>{path};
  }
  const bool is_team = word.ends_with(".so") || word.ends_with(".py");
  if (is_team) return fail(Errc::input, word + " is a team: name the drill before it");
  if (disk.exists(word)) return std::vector<std::string>{word};
  return fail(Errc::input, "\"" + word +
                               "\" is neither a drill nor a file; mirocup drill list "
                               "prints all names of drills");
}

Result<std::vector<drills::Drill>> read_drills(const std::string& word) {
  MIROCUP_TRY(const auto paths, paths_of(word));
  std::vector<drills::Drill> drills;
  system::Disk disk;
  for (const std::string& path : paths) {
    MIROCUP_TRY(const auto text, disk.read_named(path, system::size_limit::note));
    MIROCUP_TRY(auto drill, drills::parse_drill(text, path));
    drills.push_back(std::move(drill));
  }
  return drills;
}

void print_list(const std::vector<drills::Drill>& drills, bool as_json) {
  record::JsonReader::Json list = record::JsonReader::Json::array();
  for (const drills::Drill& drill : drills) {
    if (as_json) {
      list.push_back({{"name", drill.name},
                      {"title", drill.title},
                      {"teaches", drill.teaches},
                      {"version", drill.version},
                      {"league", to_string(drill.league)},
                      {"opponent", drill.opponent},
                      {"seconds", drill.seconds},
                      {"tries", drill.tries}});
      continue;
    }
    std::cout << drill.name << std::string(drill.name.size() < 26 ? 26 - drill.name.size() : 1, ' ')
              << 'v' << drill.version << "  " << system::printable(drill.title) << '\n';
  }
  if (as_json) print_json({{"drills", list}});
}

// The files of tries are named after the team, so two may not have one name.
Result<std::vector<TestedTeam>> tested_teams(const DrillOptions& options) {
  std::vector<TestedTeam> teams;
  for (const std::string& text : options.teams) {
    MIROCUP_TRY(auto team, tested_team(text, NamedAfter::itself));
    team.fault = "";  // --replay has a page of each try
    const bool is_new = std::none_of(teams.begin(), teams.end(), [&](const TestedTeam& other) {
      return other.name == team.name;
    });
    if (!is_new && !options.replay_folder.empty())
      return fail(Errc::input, "TEAM " + text + ": another team is called \"" + team.name +
                                   "\", too, and its replays would have the same files: NAME=TEAM "
                                   "gives a team another name");
    teams.push_back(std::move(team));
  }
  return teams;
}

Result<int> run_drill(DrillOptions options, const record::WriteAnswer& answer) {
  MIROCUP_TRY(const auto drills, read_drills(options.drill));
  if (options.drill == "list") {
    print_list(drills, options.json);
    return exit_yes;
  }
  if (!options.league.empty()) {
    MIROCUP_TRY(const auto entries, entries_of_league(options.league));
    for (const auto& [team, path] : entries) {
      if (path.empty()) std::cerr << "mirocup: " << team << " has no entry\n";
      if (!path.empty()) options.teams.push_back(team + '=' + path);
    }
  }
  if (options.teams.empty()) return fail(Errc::input, "a team is needed: mirocup drill DRILL TEAM");
  MIROCUP_TRY(const auto parameters,
              record::parameters_with_changes({}, options.parameters, "--param"));
  MIROCUP_TRY(const auto teams, tested_teams(options));
  MIROCUP_TRY(const auto reports, try_drills(teams, drills, options.tries, parameters, options));
  record::Json of_teams = record::Json::array();
  for (const DrillReport& report : reports) of_teams.push_back(json_of(report));
  const record::Json json = of_teams.size() == 1 ? of_teams[0] : record::Json{{"teams", of_teams}};
  MIROCUP_TRY_VOID(answer(json));
  if (options.json) {
    print_json(json);
  } else if (options.csv) {
    std::cout << csv_of(reports);
  } else {
    for (std::size_t i = 0; i < reports.size(); ++i) {
      std::vector<std::string> notes = faults_of(reports[i]);
      for (std::string& note : notes) note.insert(0, "fault: ");
      std::cout << report_text(of_teams[i], drills.size() > 1 ? "all" : "", notes);
    }
  }
  const double wanted = options.at_least.value_or(0.0);
  const bool is_enough = std::all_of(reports.begin(), reports.end(), [wanted](const auto& report) {
    return report.score() >= wanted;
  });
  return is_enough ? exit_yes : exit_no;
}

}  // namespace

void add_drill(system::Commands& commands) {
  const auto [command, o] =
      commands.add(answering<run_drill, DrillOptions>, "drill", for_teams,
                   "Try a team many times in situations and give it marks, or list the drills",
                   {"mirocup drill list", "mirocup drill shoot-open-goal mine.so --replay failed",
                    "mirocup drill all mine.so striker --csv",
                    "mirocup drill touch-the-ball --league spring --csv"});
  command
      .option("DRILL", o.drill,
              "list, all, the name of a drill, or the path of a drill or of a folder of drills")
      .required();
  command.option("TEAM", o.teams,
                 "Teams to be tested: paths of libraries or names of house teams; NAME=TEAM: the "
                 "name in the report");
  command.option("--league DIR", o.league,
                 "Test the present entry of each team of this league, as well");
  command
      .option("--tries NUMBER", o.tries,
              "Number of tries of each drill (default: the number in the drill's file)")
      .between(1, 10000);
  command
      .option("--seed SEED", o.first_seed,
              "Seed of the first try; each further try has the next seed")
      .shows_default();
  command.jobs(o.jobs, "tries");
  add_parameters(command, "--param", o.parameters, "the teams");
  command.option(
      "--replay DIR", o.replay_folder,
      "Folder to write files to: a record and a page of each failed try, and index.html, "
      "which lists the failed tries");
  command
      .option("--at-least MARKS", o.at_least,
              "Lowest score that passes: exit code 1 if a team is below it")
      .between(0.0, 100.0);
  const system::Option csv = command.flag("--csv", o.csv, "Print a line of CSV for each drill");
  command.flag("--json", o.json, "Print one JSON object").excludes(csv);
  add_answer(command, o.answer);
}

}  // namespace mirocup::app
