// SPDX-License-Identifier: MIT
//
// mirocup league start: plays a league, or resumes it.
#include "programs/league/commands.hpp"
#include "programs/league/playing.hpp"
#include "programs/league/progress_bar.hpp"
#include "programs/league/publishing.hpp"
#include "tournaments/publish/site.hpp"

#include <iostream>

namespace mirocup::league {

namespace {

struct StartOptions {
  std::string folder;
  PlayTerms play;
};

Result<int> run_start(const StartOptions& options) {
  system::Disk disk;
  const Folder folder{options.folder};
  MIROCUP_TRY(auto held,
              hold_league(disk, folder, "; to stop that, call mirocup league stop " + folder.path));

  auto progress = make_progress_reporter();
  MIROCUP_TRY(const auto end, play_league(disk, std::move(held.store), *progress, options.play));
  const LeagueState& played = end.state;
  progress->say("making pages");
  const int jobs_here = options.play.engine == "local" ? options.play.jobs : 0;
  MIROCUP_TRY(const int published, publish_league(disk, folder, jobs_here));
  progress.reset();  // removes the bar before the table is printed
  std::cout << table_text(played);
  if (played.legs() == played.played()) return end.refused > 0 ? exit_no : published;
  say_what_is_left(played);
  if (options.play.engine != "local")
    std::cerr
        << "mirocup: legs of teams that play over the network need league start without --engine\n";
  return exit_no;
}

}  // namespace

void add_start(system::Commands& commands) {
  const auto [command, o] =
      commands.add(run_start, "start", to_play, "Play the league, or resume it",
                   {"mirocup league start spring --jobs 4"});
  add_folder(command, o.folder);
  command
      .option("--engine", o.play.engine,
              "Where to play legs: on this host, or on the nodes of its Slurm cluster")
      .one_of({"local", "slurm"})
      .shows_default();
  command.flag("--watch", o.play.watched,
               "Let league serve show the legs of this host while they are played");
  command
      .option("--jobs", o.play.jobs,
              "How many legs are played at once, and after them how many pages are made at once "
              "(default: one for each processor)")
      .between(1, 1024);
  command
      .option("--dds-domain", o.play.dds_domain,
              "DDS domain for legs on this host with a team that plays over DDS")
      .between(0, 230)
      .shows_default();
}

}  // namespace mirocup::league
