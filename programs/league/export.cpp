// SPDX-License-Identifier: MIT
//
// mirocup league export: table, legs and bracket as files, or the sources of the teams.
#include "programs/league/commands.hpp"
#include "programs/league/sources.hpp"
#include "tournaments/league/league_store.hpp"
#include "tournaments/league/roster.hpp"
#include "tournaments/publish/exports.hpp"
#include "tournaments/publish/grades.hpp"

#include <iostream>
#include <vector>

namespace mirocup::league {

namespace {

struct ExportOptions {
  std::string folder;
  std::string output = "export";
  std::string drills;  // the output of mirocup drill --csv; "": none
  bool sources = false;
};

Result<std::vector<SiteFile>> files_to_export(system::Files& disk, const ExportOptions& options,
                                              const LeagueStore& store) {
  const Overview overview = league::overview(store.state());
  std::vector<SiteFile> files;
  for (const auto& [name, make] : exports(overview)) files.push_back({name, make()});
  if (options.drills.empty()) return files;
  MIROCUP_TRY(const auto drills, disk.read_named(options.drills, system::size_limit::note));
  MIROCUP_TRY(const auto people, everybody(disk, store));
  MIROCUP_TRY(auto joined, grades(overview, people, drills, options.drills));
  files.push_back(std::move(joined));
  return files;
}

Result<int> run_export(const ExportOptions& options) {
  system::Disk disk;
  MIROCUP_TRY(const auto store, LeagueStore::open(disk, Folder{options.folder}));
  if (options.sources) {
    MIROCUP_TRY_VOID(export_sources(disk, store, options.output));
    return exit_yes;
  }
  MIROCUP_TRY(const auto files, files_to_export(disk, options, store));
  MIROCUP_TRY_VOID(disk.make_folder(options.output));
  for (const SiteFile& file : files) {
    const std::string path = options.output + "/" + file.name;
    MIROCUP_TRY_VOID(disk.write(path, file.bytes));
    std::cout << path << '\n';
  }
  return exit_yes;
}

}  // namespace

void add_export(system::Commands& commands) {
  const auto [command, o] =
      commands.add(run_export, "export", to_show, "Write table, legs and bracket as files",
                   {"mirocup league export spring -o tables",
                    "mirocup league export spring --sources -o sources"});
  add_folder(command, o.folder);
  command.option("-o,--output", o.output, "Folder for the files")
      .shows_default()
      .checked("DIR", problem_with_folder);
  const system::Option sources = command.flag(
      "--sources", o.sources,
      "Write the sources of the teams, and the code that all teams were given, for JPlag");
  command
      .option("--drills", o.drills,
              "File with the marks of the teams, as mirocup drill --csv prints them; adds "
              "grades.csv to the files")
      .named("FILE")
      .excludes(sources);
}

}  // namespace mirocup::league
