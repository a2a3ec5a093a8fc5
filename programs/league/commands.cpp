// SPDX-License-Identifier: MIT
#include "programs/league/commands.hpp"

#include "programs/league/progress_bar.hpp"
#include "programs/league/publishing.hpp"
#include "record/json_reader.hpp"
#include "system/file_lock.hpp"
#include "system/printable.hpp"
#include "tournaments/league/apply.hpp"
#include "tournaments/league/roster.hpp"
#include "tournaments/play/program.hpp"
#include "tournaments/play/runner.hpp"
#include "tournaments/play/slurm_runner.hpp"
#include "tournaments/publish/exports.hpp"
#include "tournaments/publish/grades.hpp"
#include "tournaments/publish/league_statistics.hpp"
#include "tournaments/publish/site.hpp"
#include "tournaments/publish/snapshot.hpp"

#include <nlohmann/json.hpp>

#include <csignal>
#include <filesystem>
#include <iostream>
#include <memory>
#include <unistd.h>

namespace mirocup::league {

namespace {

// Returns the last part of the path of a folder, which may be written as "." or end in a slash.
std::string name_of_folder(const std::string& path) {
  const auto whole = std::filesystem::absolute(path).lexically_normal();
  return (whole.has_filename() ? whole : whole.parent_path()).filename().string();
}

Result<LeagueFile> file_from(system::Files& files, const LeagueOptions& options) {
  if (!options.config.empty()) {
    MIROCUP_TRY(const auto text,
                files.read(options.config, {.max_size = system::size_limit::league_file,
                                            .links = system::Links::followed}));
    auto file = parse_league_file(text, options.config, current_rules);
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
  file.seed = options.seed;
  file.title = name_of_folder(options.folder);
  if (!options.format.empty()) file.format.kind = *from_string<FormatKind>(options.format);
  if (file.format.kind == FormatKind::swiss)
    file.tie_breaks.insert(file.tie_breaks.begin(), TieBreak::opponents_points);
  if (options.half_s > 0.0) file.rules.half_s = options.half_s;
  file.conditions = default_conditions();
  for (const std::string& text : options.teams) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos) {
      return fail(Errc::input, "--team " + text +
                                   ": NAME=house:TEAM, NAME=FILE.so, NAME=FILE.py, "
                                   "NAME=firasim:NAME or, if it hands in later, NAME=submitted is "
                                   "expected");
    }
    file.teams.push_back(
        {.name = text.substr(0, equals), .source = text.substr(equals + 1), .over_dds = false});
  }
  // Parsed again, because the parser checks the names.
  return parse_league_file(print_league_file(file), "--team");
}

}  // namespace

void say_what_is_left(const LeagueState& state) {
  std::cerr << "mirocup: " << state.legs() - state.played() << " legs are not decided\n";
  for (std::size_t i = 0; i < state.teams.size(); ++i) {
    if (state.teams[i].status != TeamStatus::paused) continue;
    std::cerr << "mirocup: " << state.file.teams[i].name
              << " is paused: " << system::printable(state.teams[i].why)
              << "; league resume or league withdraw decides\n";
  }
  for (const FixtureState& f : state.fixtures) {
    for (int leg = 0; leg < f.needed(); ++leg) {
      if (f.legs[leg].played || f.legs[leg].host_faults < max_attempts) continue;
      std::cerr << "mirocup: " << f.fixture.id() << " leg " << leg + 1 << ": the host failed "
                << f.legs[leg].host_faults << " times; see the journal, then start again\n";
    }
  }
}

Result<LeagueState> play_league(system::Files& files, LeagueStore store, ProgressReporter& progress,
                                const LeagueOptions& options) {
  const auto state_of = [](auto& runner, const Result<int>& left) -> Result<LeagueState> {
    if (!left) return tl::unexpected(left.error());
    return runner.state();
  };
  const record::Software program = record::this_software();
  MIROCUP_TRY_VOID(expect_program(files, store, program, options.accepts_other_program));
  MIROCUP_TRY_VOID(keep_program(files, store.folder(), program));
  if (options.engine == "slurm") {
    SlurmRunner runner(files, std::move(store), progress);
    return state_of(runner, runner.run(options.jobs));
  }
  Runner runner(files, std::move(store), progress);
  return state_of(runner, runner.run({.jobs = options.jobs,
                                      .watched = options.watched,
                                      .dds_domain = options.dds_domain}));
}

Result<int> run_init(const LeagueOptions& options) {
  system::Disk disk;
  MIROCUP_TRY(const auto file, file_from(disk, options));
  const int teams = static_cast<int>(file.teams.size());
  // Of a league whose teams come later, only its start can say more.
  if (file.format.kind == FormatKind::swiss && teams > 1) {
    if (const std::string why = objection(file.format, teams); !why.empty())
      return fail(Errc::input, options.folder + ": " + why);
  }
  const Folder folder{options.folder};
  MIROCUP_TRY_VOID(init_folder(disk, folder, file));
  const LeagueState state = new_league(file);
  std::cout << folder.path << ": " << file.teams.size()
            << (file.teams.size() == 1 ? " team, " : " teams, ") << state.legs() << " legs\n";
  return exit_yes;
}

Result<int> run_start(const LeagueOptions& options) {
  system::Disk disk;
  const Folder folder{options.folder};
  std::string notice;
  MIROCUP_TRY(auto store, LeagueStore::open(disk, folder, &notice));
  if (!notice.empty()) std::cerr << "mirocup: " << notice << '\n';
  MIROCUP_TRY(const auto mine, system::FileLock::try_acquire(folder.running()));
  if (!mine) {
    return fail(Errc::unavailable, folder.path + " is being played already; mirocup league stop " +
                                       folder.path + " ends that");
  }

  auto progress = make_progress_reporter();
  MIROCUP_TRY(const auto played, play_league(disk, std::move(store), *progress, options));
  progress->say("making pages");
  const int jobs_here = options.engine == "local" ? options.jobs : 0;
  MIROCUP_TRY_VOID(publish_league(disk, folder, jobs_here));
  progress.reset();  // removes the bar before the table is printed
  std::cout << table_text(played);
  if (played.legs() == played.played()) return exit_yes;
  say_what_is_left(played);
  if (options.engine != "local")
    std::cerr << "mirocup: what teams over the network play is left to league start without "
                 "--engine\n";
  return exit_no;
}

// Asks the process that plays the league to stop. The lock on the file tells whether there is one.
Result<int> run_stop(const LeagueOptions& options) {
  const Folder folder{options.folder};
  system::Disk disk;
  MIROCUP_TRY_VOID(expect_league(disk, folder));
  // A second SIGINT could merge with the first, so the second request is another signal.
  std::vector<int> signals{SIGINT};
  if (options.now) signals.push_back(SIGTERM);
  MIROCUP_TRY(const auto asked, system::FileLock::signal_holder(folder.running(), signals));
  if (!asked) {
    std::cout << folder.path << " is not being played\n";
    return exit_no;
  }
  std::cout << folder.path << (options.now ? " stops\n" : " stops when its legs are played\n");
  return exit_yes;
}

Result<int> run_status(const LeagueOptions& options) {
  system::Disk disk;
  MIROCUP_TRY(const auto store, LeagueStore::open(disk, Folder{options.folder}));
  const LeagueState& state = store.state();
  if (options.entries) {
    MIROCUP_TRY_VOID(print_roster(disk, store, options.json));
  } else if (options.json) {
    std::cout << record::json_text(table_json(overview(state))) << '\n';
  } else {
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
    if (const std::string at = last_leg_at(store.journal()); !at.empty())
      std::cout << "the last leg was played at " << shown_time(state.file, at) << '\n';
  }
  return state.played() == state.legs() ? exit_yes : exit_no;
}

Result<int> run_publish(const LeagueOptions& options) {
  system::Disk disk;
  MIROCUP_TRY(const auto store, LeagueStore::open(disk, Folder{options.folder}));
  // site/ has what is released, so the pages of other rounds go to another folder.
  const Folder folder{options.through.empty() ? options.folder : options.output};
  if (!options.through.empty() && disk.exists(folder.config()))
    return fail(Errc::input, "--output " + folder.path +
                                 " is a league, whose records and pages would be replaced: name a "
                                 "folder for the pages alone");
  MIROCUP_TRY_VOID(
      options.through.empty()
          ? publish_league(disk, folder)
          : state_through(store.state(), store.journal(), options.through)
                .and_then([&](const LeagueState& shown) {
                  return copy_records(disk, store.folder(), shown, folder).and_then([&] {
                    return publish_site(disk, folder, shown, {});
                  });
                }));
  std::cout << std::filesystem::absolute(folder.site() + "/index.html").lexically_normal().string()
            << '\n';
  return exit_yes;
}

Result<int> run_stats(const StatsOptions& options) {
  system::Disk disk;
  MIROCUP_TRY(const auto store, LeagueStore::open(disk, Folder{options.folder}));
  MIROCUP_TRY(const auto legs, all_statistics(disk, store.folder(), store.state()));
  MIROCUP_TRY(const auto text, statistics::report(legs, options));
  std::cout << text;
  return exit_yes;
}

namespace {

Result<std::vector<SiteFile>> files_to_export(system::Files& disk, const LeagueOptions& options,
                                              const LeagueStore& store) {
  const Overview overview = league::overview(store.state());
  std::vector<SiteFile> files;
  for (const auto& [name, make] : exports(overview)) files.push_back({name, make()});
  if (options.drills.empty()) return files;
  MIROCUP_TRY(const auto drills, disk.read(options.drills, {.max_size = system::size_limit::note,
                                                            .links = system::Links::followed}));
  MIROCUP_TRY(const auto people, everybody(disk, store));
  MIROCUP_TRY(auto joined, grades(overview, people, drills, options.drills));
  files.push_back(std::move(joined));
  return files;
}

}  // namespace

Result<int> run_export(const LeagueOptions& options) {
  system::Disk disk;
  MIROCUP_TRY(const auto store, LeagueStore::open(disk, Folder{options.folder}));
  MIROCUP_TRY(const auto files, files_to_export(disk, options, store));
  MIROCUP_TRY_VOID(disk.make_folder(options.output));
  for (const SiteFile& file : files) {
    const std::string path = options.output + "/" + file.name;
    MIROCUP_TRY_VOID(disk.write(path, file.bytes));
    std::cout << path << '\n';
  }
  return exit_yes;
}

}  // namespace mirocup::league
