// SPDX-License-Identifier: MIT
//
// mirocup league grades: a row for each team, or for each student.
#include "tournaments/publish/grades.hpp"

#include "programs/league/commands.hpp"
#include "programs/league/publishing.hpp"
#include "tournaments/league/class_list.hpp"
#include "tournaments/league/roster.hpp"
#include "tournaments/publish/exports.hpp"

#include <iostream>

namespace mirocup::league {

namespace {

struct GradesOptions {
  std::string folder;
  std::string drills;  // the output of mirocup drill --csv; "": none
  std::string output;
  bool per_member = false;
  bool moodle = false;
  bool gradescope = false;
};

GradesLayout layout_of(const GradesOptions& options) {
  if (options.moodle) return GradesLayout::moodle;
  if (options.gradescope) return GradesLayout::gradescope;
  return options.per_member ? GradesLayout::members : GradesLayout::teams;
}

Result<int> run_grades(const GradesOptions& options) {
  system::Disk disk;
  const Folder folder{options.folder};
  MIROCUP_TRY(const auto store, LeagueStore::open(disk, folder));
  MIROCUP_TRY(const auto found, say_gaps(disk, store));
  const int result = found.lost.empty() ? exit_yes : exit_no;
  std::string drills;
  if (!options.drills.empty()) {
    MIROCUP_TRY(drills, disk.read_named(options.drills, system::size_limit::note));
  }
  MIROCUP_TRY_VOID(
      spare_class_list(disk, folder, options.output.empty() ? "/proc/self/fd/1" : options.output));
  MIROCUP_TRY(const auto people, everybody(disk, store));
  MIROCUP_TRY(const auto file,
              grades(overview(store.state()), people, drills, options.drills, layout_of(options)));
  if (options.output.empty()) {
    std::cout << file.bytes;
    return result;
  }
  MIROCUP_TRY_VOID(disk.write(options.output, file.bytes, system::Readers::owner));
  std::cout << options.output << '\n';
  return result;
}

}  // namespace

void add_grades(system::Commands& commands) {
  const auto [command, o] = commands.add(
      run_grades, "grades", to_show, "Print the figures for a lecturer's grades, as CSV",
      {"mirocup league grades spring --drills drills.csv -o grades.csv",
       "mirocup league grades spring --moodle -o moodle.csv"});
  add_folder(command, o.folder);
  command
      .option("--drills", o.drills,
              "File with the marks of the teams, as mirocup drill --csv prints them")
      .named("FILE");
  const system::Option per_member =
      command.flag("--per-member", o.per_member, "Write a row for each member of a team");
  const system::Option moodle =
      command.flag("--moodle", o.moodle,
                   "Write a row for each student, as Moodle's grade import reads it; the class "
                   "list needs a column mail or number");
  const system::Option gradescope = command.flag(
      "--gradescope", o.gradescope, "Write a row for each student, with Gradescope's columns");
  moodle.excludes(per_member).excludes(gradescope);
  gradescope.excludes(per_member);
  command.option("-o,--output", o.output,
                 "File to write to, which only you can then read (default: standard output)");
}

}  // namespace mirocup::league
