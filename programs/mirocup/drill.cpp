// SPDX-License-Identifier: MIT
//
// mirocup drill: tries situations many times and gives marks.
#include "plugins/host/sandbox/probe.hpp"
#include "programs/mirocup/commands.hpp"
#include "programs/mirocup/drill_report.hpp"
#include "record/team_parameters_json.hpp"
#include "system/child_process.hpp"
#include "system/locations.hpp"
#include "system/text.hpp"

#include <algorithm>
#include <filesystem>
#include <list>
#include <unistd.h>

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

// `text` is a team, or NAME=TEAM: the entries of a league all have the same file name. `what`
// stands before `text` in the sentence about a team that is on the network.
Result<server::TeamChoice> choose(const std::string& text, const std::string& what) {
  const std::size_t equals = text.find('=');
  const bool is_named = equals != std::string::npos && equals < text.find('/');
  auto choice = server::choose_team(is_named ? text.substr(equals + 1) : text);
  if (choice && is_named) choice->info.name = text.substr(0, equals);
  if (choice && record::is_on_network(choice->info.kind)) {
    return fail(Errc::input, what + text + ": drills are for libraries and house teams");
  }
  return choice;
}

// Returns the name of the team in a report and in the names of files: that of NAME=TEAM, else its
// own, else that of its file.
Result<std::string> name_of(const std::string& team) {
  MIROCUP_TRY(const auto choice, choose(team, "TEAM "));
  const std::string& known = choice.info.name;
  if (choice.info.kind != record::TeamKind::plugin || team.starts_with(known + "=")) return known;
  MIROCUP_TRY(const auto isolation, plugins::strongest_isolation());
  plugins::ProcessTerms terms;
  terms.isolation = isolation;
  const match::Leg leg(match::Setup{});
  MIROCUP_TRY(auto seat,
              server::TeamSeat::take_in_process(choice, leg.briefing(drills::tested), terms));
  const std::string own = seat.wait_until_ready() ? seat.own_name() : "";
  return own.empty() || own.find('/') != std::string::npos ? known : own;
}

Result<DrillTeams> teams_of(const drills::Drill& drill, const std::string& team,
                            const std::string& name, const match::TeamParameters& parameters) {
  MIROCUP_TRY(auto tested, choose(team, "TEAM "));
  DrillTeams teams{.tested = std::move(tested), .opponent = {}, .mates = std::nullopt};
  teams.tested.info.name = name;
  teams.tested.info.parameters = drill.parameters;
  for (const auto& [key, value] : parameters) teams.tested.info.parameters[key] = value;
  const auto choose_in_drill = [&drill](const std::string& text, const char* key) {
    return choose(text, "").map_error([&](const Error& error) {
      return Error{error.code, drill.name + ": " + key + ": " + error.what};
    });
  };
  MIROCUP_TRY(teams.opponent, choose_in_drill(drill.opponent, "/opponent"));
  if (drill.mates.empty()) return teams;
  MIROCUP_TRY(teams.mates, choose_in_drill(drill.mates, "/mates"));
  return teams;
}

// Returns NAME=TEAM for the present entry of each team of a league, in the order of its teams. Only
// mirocup-league can read a league.
Result<std::vector<std::string>> entries_of(const std::string& league) {
  const std::string program = system::sibling_program("mirocup-league");
  MIROCUP_TRY(const auto answer,
              system::ask({program, "status", league, "--entries", "--json"}, {.seconds = 60.0}));
  const std::string last = system::last_line(answer.output);
  if (answer.code > exit_no) return fail(Errc::input, system::replaced(last, "mirocup: ", ""));
  return record::read_json<std::vector<std::string>>(
      last, league, Errc::input, [&](const record::JsonReader& json) {
        std::vector<std::string> teams;
        for (const record::JsonReader& team : json.at("teams").elements()) {
          const std::string name = team.at("team").text();
          const record::JsonReader playing = team.at("plays_with");
          const record::JsonReader entry = playing.is_null() ? team.at("last_accepted") : playing;
          if (entry.is_null()) std::cerr << "mirocup: " << name << " has no entry\n";
          if (!entry.is_null())
            teams.push_back(name + '=' + league + "/entries/" + name + '/' +
                            std::to_string(entry.as<int>()) + "/strategy.so");
        }
        return teams;
      });
}

// On a terminal, a line that counts.
class Progress {
 public:
  explicit Progress(int all) : all_(all), is_shown_(isatty(STDERR_FILENO) != 0) {}
  ~Progress() { clear(); }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void clear() {
    if (is_shown_ && shown_ >= 0) std::cerr << "\r\033[K" << std::flush;
    shown_ = -1;
  }

  void show(int done) {
    if (!is_shown_ || done == shown_) return;
    shown_ = done;
    std::cerr << "\r" << done << " of " << all_ << " tries" << std::flush;
  }

 private:
  int all_;
  int shown_ = -1;
  bool is_shown_;
};

// Tries all drills with one team.
Result<DrillReport> test_team(const std::string& team, const std::string& name,
                              const std::vector<drills::Drill>& drills, const DrillOptions& options,
                              const match::TeamParameters& parameters,
                              const std::function<void(int)>& progress) {
  DrillReport report;
  report.team = name;
  std::list<DrillTeams> teams;  // tasks point to its elements
  std::vector<DrillTask> tasks;
  for (const drills::Drill& drill : drills) {
    MIROCUP_TRY(auto of_this, teams_of(drill, team, name, parameters));
    teams.push_back(std::move(of_this));
    tasks.push_back({&drill, &teams.back(), options.tries.value_or(drill.tries)});
    report.drills.push_back(&drill);
  }
  MIROCUP_TRY(report.tries, play_drills(tasks, options, progress));
  return report;
}

// The files of tries are named after the team, so two may not have one name.
Result<std::vector<std::string>> names_of_teams(const DrillOptions& options) {
  std::vector<std::string> names;
  for (const std::string& team : options.teams) {
    MIROCUP_TRY(auto name, name_of(team));
    const bool is_new = std::find(names.begin(), names.end(), name) == names.end();
    if (!is_new && !options.replay_folder.empty())
      return fail(Errc::input, "TEAM " + team + ": another team is called \"" + name +
                                   "\", too, and its replays would have the same files: NAME=TEAM "
                                   "gives a team another name");
    names.push_back(std::move(name));
  }
  return names;
}

Result<int> run_drill(DrillOptions options, const record::WriteAnswer& answer) {
  MIROCUP_TRY(const auto drills, read_drills(options.drill));
  if (options.drill == "list") {
    print_list(drills, options.json);
    return exit_yes;
  }
  if (!options.league.empty()) {
    MIROCUP_TRY(const auto entries, entries_of(options.league));
    options.teams.insert(options.teams.end(), entries.begin(), entries.end());
  }
  if (options.teams.empty()) return fail(Errc::input, "a team is needed: mirocup drill DRILL TEAM");
  MIROCUP_TRY(const auto parameters,
              record::parameters_with_changes({}, options.parameters, "--param"));
  MIROCUP_TRY(const auto names, names_of_teams(options));
  system::Disk disk;
  if (!options.replay_folder.empty()) MIROCUP_TRY_VOID(disk.make_folder(options.replay_folder));

  int all_tries = 0;
  for (const drills::Drill& drill : drills) all_tries += options.tries.value_or(drill.tries);
  Progress progress(all_tries * static_cast<int>(options.teams.size()));
  std::vector<DrillReport> reports;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto show = [&](int done) { progress.show(static_cast<int>(i) * all_tries + done); };
    MIROCUP_TRY(auto report,
                test_team(options.teams[i], names[i], drills, options, parameters, show));
    reports.push_back(std::move(report));
  }
  progress.clear();
  if (!options.replay_folder.empty()) {
    const std::string list = options.replay_folder + "/index.html";
    MIROCUP_TRY_VOID(disk.write(list, failed_page(reports)));
    std::cerr << list << " lists the failed tries\n";
  }
  MIROCUP_TRY_VOID(answer(json_of(reports)));
  if (options.json) {
    print_json(json_of(reports));
  } else if (options.csv) {
    std::cout << csv_of(reports);
  } else {
    for (const DrillReport& report : reports) std::cout << text_of(report);
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
