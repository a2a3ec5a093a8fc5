// SPDX-License-Identifier: MIT
#include "programs/league/playing.hpp"

#include "programs/league/publishing.hpp"
#include "record/kept_module.hpp"
#include "system/printable.hpp"
#include "tournaments/play/program.hpp"
#include "tournaments/play/progress_reporter.hpp"
#include "tournaments/play/slurm_runner.hpp"

#include <iostream>

namespace mirocup::league {

Result<HeldLeague> hold_league(system::Files& files, const Folder& folder,
                               const std::string& advice) {
  MIROCUP_TRY_VOID(expect_owner(folder));
  std::string notice;
  MIROCUP_TRY(auto store, LeagueStore::open(files, folder, &notice));
  if (!notice.empty()) std::cerr << "mirocup: " << notice << '\n';
  MIROCUP_TRY(auto lock, system::FileLock::try_acquire(folder.running()));
  if (!lock) return fail(Errc::unavailable, folder.path + " is being played already" + advice);
  return HeldLeague{std::move(store), std::move(*lock)};
}

static Result<PlayedLeague> play_league(system::Files& files, LeagueStore store,
                                        ProgressReporter& progress, const PlayTerms& terms) {
  const auto end_of = [](auto& runner, const Result<int>& left) -> Result<PlayedLeague> {
    if (!left) return tl::unexpected(left.error());
    return PlayedLeague{runner.state(), runner.refused()};
  };
  MIROCUP_TRY_VOID(expect_program(store, record::this_software()));
  const Folder& folder = store.folder();
  if (terms.nat && !files.exists(folder.credentials() + "/server")) {
    return fail(Errc::input,
                "--nat: without credentials anybody could join for a team: mirocup "
                "league credentials " +
                    folder.path + " makes them");
  }
  MIROCUP_TRY_VOID(record::keep_module(files, store.folder().path));
  if (terms.engine == "slurm") {
    SlurmRunner runner(files, std::move(store), progress);
    return end_of(runner, runner.run(terms.jobs));
  }
  Runner runner(files, std::move(store), progress);
  return end_of(runner, runner.run(terms));
}

void add_nat(const system::Command& command, PlayTerms& terms) {
  command.flag("--nat", terms.nat,
               "Answer teams over DDS where their packets come from; needs credentials");
}

Result<PlayedLeague> play_and_publish(system::Files& files, LeagueStore store,
                                      const PlayTerms& terms) {
  const Folder folder = store.folder();
  const auto progress = make_progress_reporter();
  MIROCUP_TRY(auto played, play_league(files, std::move(store), *progress, terms));
  progress->say("making pages");
  MIROCUP_TRY(played.published,
              publish_league(files, folder, terms.engine == "local" ? terms.jobs : 0));
  return played;
}

static void say_what_is_left(const LeagueState& state) {
  std::cerr << "mirocup: " << state.legs() - state.played() << " legs are not decided\n";
  for (std::size_t i = 0; i < state.teams.size(); ++i) {
    if (state.teams[i].status != TeamStatus::paused) continue;
    std::cerr << "mirocup: " << state.file.teams[i].name
              << " is paused: " << system::printable(state.teams[i].why)
              << "; league resume lets it play again, league withdraw takes it out of the league\n";
  }
  for (const FixtureState& f : state.fixtures) {
    for (int leg = 0; leg < f.needed(); ++leg) {
      if (f.legs[leg].played || f.legs[leg].host_faults < max_attempts) continue;
      std::cerr << "mirocup: " << f.fixture.id() << " leg " << leg + 1 << ": failed "
                << f.legs[leg].host_faults
                << " times by the host's fault; the journal has the reasons, and the league's next "
                   "start tries this leg again\n";
    }
  }
}

int exit_code_of(const PlayedLeague& played, const LeagueState& now) {
  const bool is_over = now.legs() == now.played();
  if (!is_over) say_what_is_left(now);
  return is_over && played.refused == 0 ? played.published : exit_no;
}

}  // namespace mirocup::league
