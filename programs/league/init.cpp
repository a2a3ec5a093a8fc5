// SPDX-License-Identifier: MIT
//
// mirocup league init: makes a league.
#include "programs/league/commands.hpp"
#include "programs/league/finals.hpp"
#include "record/rules_json.hpp"
#include "tournaments/league/apply.hpp"

#include <filesystem>

namespace mirocup::league {

namespace {

struct InitOptions : LeagueOptions {
  std::string config;
  std::vector<std::string> teams;  // NAME=ENTRY
  std::string format;
  double half_s = 0.0;  // duration of a half, seconds; 0: that of the rules
  std::uint64_t seed = 1;
  std::string from;  // a league whose table gives the teams; "": none
  int top = 0;       // number of them
};

// Returns the last part of the path of a folder, which may be written as "." or end in a slash.
std::string name_of_folder(const std::string& path) {
  const auto whole = std::filesystem::absolute(path).lexically_normal();
  return (whole.has_filename() ? whole : whole.parent_path()).filename().string();
}

// `season` is the league of --from, or null.
Result<LeagueFile> file_from(system::Files& files, const InitOptions& options,
                             const LeagueStore* season) {
  if (!options.config.empty()) {
    MIROCUP_TRY(const auto text, files.read_named(options.config, system::size_limit::league_file));
    auto file = parse_league_file(text, options.config);
    if (!file) return file;
    // Paths of libraries are relative to the folder of the file.
    const std::filesystem::path base = std::filesystem::path(options.config).parent_path();
    for (TeamConfig& team : file->teams) {
      if (team.is_firasim()) {
        team.program.folder =
            std::filesystem::absolute(base / team.program.folder).lexically_normal().string();
      } else if (!team.is_house() && !team.hands_in()) {
        team.source = (base / team.source).string();
      }
    }
    if (!file->conditions) file->conditions = default_conditions();
    return file;
  }
  LeagueFile file;
  file.title = name_of_folder(options.folder);
  if (season != nullptr) {
    MIROCUP_TRY(file, finals(files, *season, file.title, options.top));
  }
  file.seed = options.seed;
  if (!options.format.empty()) file.format.kind = *from_string<FormatKind>(options.format);
  if (file.format.kind == FormatKind::swiss)
    file.tie_breaks.insert(file.tie_breaks.begin(), TieBreak::opponents_points);
  if (options.half_s > 0.0) file.rules.half_s = options.half_s;
  if (!file.conditions) file.conditions = default_conditions();
  for (const std::string& text : options.teams) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos)
      return fail(Errc::input,
                  "--team " + text +
                      ": NAME=house:TEAM, NAME=FILE.so, NAME=FILE.py, "
                      "NAME=firasim:NAME or NAME=submitted (it hands in later) is expected");
    file.teams.push_back(
        {.name = text.substr(0, equals), .source = text.substr(equals + 1), .over_dds = false});
  }
  // Parsed again, because the parser checks the names.
  return parse_league_file(print_league_file(file), "--team");
}

Result<int> run_init(const InitOptions& options) {
  system::Disk disk;
  std::optional<LeagueStore> season;
  if (!options.from.empty()) {
    MIROCUP_TRY(season, LeagueStore::open(disk, Folder{options.from}));
  }
  MIROCUP_TRY(const auto file, file_from(disk, options, season ? &*season : nullptr));
  const int teams = static_cast<int>(file.teams.size());
  // Of a league whose teams come later, only its start can say more.
  if (file.format.kind == FormatKind::swiss && teams > 1) {
    if (const std::string why = objection(file.format, teams); !why.empty())
      return fail(Errc::input, options.folder + ": " + why);
  }
  const Folder folder{options.folder};
  MIROCUP_TRY_VOID(season ? init_from(disk, *season, folder, file, false)
                          : init_folder(disk, folder, file));
  const LeagueState state = new_league(file);
  std::cout << folder.path << ": " << file.teams.size()
            << (file.teams.size() == 1 ? " team, " : " teams, ") << state.legs() << " legs\n";
  return exit_yes;
}

}  // namespace

void add_init(system::Commands& commands) {
  const auto [command, o] = add_command(
      commands, run_init, "init", to_make, "Make a league",
      {"mirocup league init spring --team alpha=alpha.so --team house=house:striker --half 120",
       "mirocup league init finals --from spring --top 8",
       "mirocup league init spring --config league.json"});
  const system::Option config =
      command.option("--config FILE", o.config, "Make the league from this league.json");
  command
      .option("--team NAME=TEAM", o.teams,
              "NAME=house:TEAM, NAME=FILE.so, NAME=FILE.py, NAME=firasim:NAME (a person starts its "
              "program), or NAME=submitted (the team hands in later); once for each team")
      .excludes(config);
  const system::Option from = command
                                  .option("--from LEAGUE", o.from,
                                          "League whose table gives the teams, their entries and "
                                          "their seeds for a knockout, or for another --format")
                                  .excludes(config);
  const system::Option top =
      command.option("--top NUMBER", o.top, "Number of teams from the top of that table")
          .between(2, static_cast<int>(max_teams))
          .needs(from);
  from.needs(top);
  command.option("--format", o.format, "Format of the schedule (default: double_round_robin)")
      .one_of(system::names_of<FormatKind>())
      .excludes(config);
  command.option("--half SECONDS", o.half_s, "Length of a half in seconds")
      .between(record::min_half_s, record::max_half_s)
      .excludes(config);
  command.option("--seed SEED", o.seed, "Seed of all random draws").is_a_seed().excludes(config);
}

}  // namespace mirocup::league
