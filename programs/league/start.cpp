// SPDX-License-Identifier: MIT
//
// The subcommands start, which plays a league or resumes it, and stop.
#include "programs/league/commands.hpp"
#include "programs/league/playing.hpp"
#include "tournaments/publish/site.hpp"

#include <csignal>

namespace mirocup::league {

namespace {

struct StartOptions : LeagueOptions {
  PlayTerms play;
};

Result<int> run_start(const StartOptions& options) {
  system::Disk disk;
  const Folder folder{options.folder};
  MIROCUP_TRY(auto held,
              hold_league(disk, folder, "; to stop that, call mirocup league stop " + folder.path));
  MIROCUP_TRY(const auto end, play_and_publish(disk, std::move(held.store), options.play));
  std::cout << table_text(end.state);
  const int result = exit_code_of(end, end.state);
  if (end.state.legs() != end.state.played() && options.play.engine != "local")
    std::cerr
        << "mirocup: legs of teams that play over the network need league start without --engine\n";
  return result;
}

struct StopOptions : LeagueOptions {
  bool now = false;
};

// Asks the process that plays the league to stop. The lock on the file tells whether there is one.
Result<int> run_stop(const StopOptions& options) {
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
  std::cout << folder.path
            << (options.now ? " stops\n" : " stops when its present legs are over\n");
  return exit_yes;
}

}  // namespace

void add_start(system::Commands& commands) {
  const auto [command, o] =
      add_command(commands, run_start, "start", to_play, "Play the league, or resume it",
                  {"mirocup league start spring --jobs 4"});
  command
      .option("--engine", o.play.engine,
              "Where to play legs: on this host, or on the nodes of its Slurm cluster")
      .one_of({"local", "slurm"})
      .shows_default();
  command.flag("--watch", o.play.watched,
               "Let league serve show the legs of this host while they are played");
  command
      .option("--jobs NUMBER", o.play.jobs,
              "How many legs are played at once, and after them how many pages are made at once "
              "(default: one for each processor)")
      .between(1, 1024);
  command
      .option("--dds-domain NUMBER", o.play.dds_domain,
              "DDS domain for legs on this host with a team that plays over DDS")
      .between(0, 230)
      .shows_default();
  add_nat(command, o.play);
}

void add_stop(system::Commands& commands) {
  const auto [command, o] =
      add_command(commands, run_stop, "stop", to_play, "Stop a league that is being played",
                  {"mirocup league stop spring"});
  command.flag("--now", o.now, "Also stop the present legs, instead of playing them to their end");
}

}  // namespace mirocup::league
