// SPDX-License-Identifier: MIT
//
// The subcommands for the decisions of a person: award, rule, void, withdraw, pause, resume. Each
// decision is a line of the journal with a reason; the lines before it stay. Decisions may be made
// while the league is being played.
#include "core/base/assert.hpp"
#include "tournaments/app/commands.hpp"
#include "tournaments/league/league_store.hpp"

#include <ctime>
#include <iostream>
#include <sstream>

namespace mirocup::league {

namespace {

// Returns the time, as decisions carry it.
std::string now_text() {
  return utc_text(std::time(nullptr));
}

// Returns the legs that the options name: one, or all of the fixture.
Result<std::vector<int>> legs_of(const LeagueStore& store, const RulingOptions& options) {
  const auto index = store.state().find_fixture(options.fixture);
  if (!index) return fail(Errc::input, "there is no fixture " + options.fixture);
  if (options.leg > 0) return std::vector<int>{options.leg};
  std::vector<int> legs;
  for (int leg = 1; leg <= store.state().fixtures[*index].needed(); ++leg) legs.push_back(leg);
  return legs;
}

Result<int> rule(const RulingOptions& options, int home_goals, int away_goals) {
  system::Disk disk;
  auto store = LeagueStore::open(disk, Folder{options.folder});
  if (!store) return tl::unexpected(store.error());
  const auto legs = legs_of(*store, options);
  if (!legs) return tl::unexpected(legs.error());
  for (const int leg : *legs) {
    if (auto written = store->write(Ruled{.fixture = options.fixture,
                                          .leg = leg,
                                          .score = {.home = home_goals, .away = away_goals},
                                          .why = options.reason,
                                          .by = options.by,
                                          .at = now_text()});
        !written) {
      return tl::unexpected(written.error());
    }
    const LeagueState& state = store->state();
    const Fixture& fixture = state.fixtures[*state.find_fixture(options.fixture)].fixture;
    std::cout << options.fixture << " leg " << leg << ": " << state.name(fixture.home) << ' '
              << home_goals << " : " << away_goals << ' ' << state.name(fixture.away) << '\n';
  }
  return exit_yes;
}

// Opens the league and writes the event.
Result<int> write_event(const RulingOptions& options, const Event& event) {
  system::Disk disk;
  auto store = LeagueStore::open(disk, Folder{options.folder});
  if (!store) return tl::unexpected(store.error());
  if (auto written = store->write(event); !written) return tl::unexpected(written.error());
  return exit_yes;
}

}  // namespace

Result<int> run_award(const RulingOptions& options) {
  system::Disk disk;
  const auto store = LeagueStore::open(disk, Folder{options.folder});
  if (!store) return tl::unexpected(store.error());
  const LeagueState& state = store->state();
  const auto index = state.find_fixture(options.fixture);
  if (!index) return fail(Errc::input, "there is no fixture " + options.fixture);
  const Fixture& fixture = state.fixtures[*index].fixture;
  const auto team = state.find_team(options.team);
  if (!team || (*team != fixture.home && *team != fixture.away))
    return fail(Errc::input, options.team + " does not play in " + options.fixture);
  const int goals = state.file.rules.forfeit_goals;
  return rule(options, *team == fixture.home ? goals : 0, *team == fixture.home ? 0 : goals);
}

Result<int> run_rule(const RulingOptions& options) {
  int home = -1;
  int away = -1;
  char colon = 0;
  std::istringstream text(options.score);
  if (!(text >> home >> colon >> away) || colon != ':' || !(text >> std::ws).eof() || home < 0 ||
      away < 0) {
    return fail(Errc::input, options.score + " is no score: HOME:AWAY is expected, as in 2:1");
  }
  return rule(options, home, away);
}

Result<int> run_void(const RulingOptions& options) {
  system::Disk disk;
  auto store = LeagueStore::open(disk, Folder{options.folder});
  if (!store) return tl::unexpected(store.error());
  const auto legs = legs_of(*store, options);
  if (!legs) return tl::unexpected(legs.error());
  for (const int leg : *legs) {
    const auto index = store->state().find_fixture(options.fixture);
    const int attempt =
        leg <= max_legs ? store->state().fixtures[*index].legs[leg - 1].voids + 1 : 1;
    if (auto written = store->write(LegVoided{.fixture = options.fixture,
                                              .leg = leg,
                                              .attempt = attempt,
                                              .cause = VoidCause::ruling,
                                              .why = options.reason,
                                              .by = options.by,
                                              .at = now_text()});
        !written) {
      return tl::unexpected(written.error());
    }
    std::cout << options.fixture << " leg " << leg << ": void; league start plays it again\n";
  }
  return exit_yes;
}

Result<int> run_withdraw(const RulingOptions& options) {
  const auto results = from_string<WithdrawnResults>(options.results);
  MIROCUP_ASSERT(results);  // the command line accepts no other words
  const auto done = write_event(options, Withdrawn{.team = options.team,
                                                   .results = *results,
                                                   .why = options.reason,
                                                   .by = options.by,
                                                   .at = now_text()});
  if (done) {
    std::cout << options.team << " has withdrawn; "
              << (*results == WithdrawnResults::keep
                      ? "its results stay, the others win what is left\n"
                      : "its results count for nothing\n");
  }
  return done;
}

Result<int> run_pause(const RulingOptions& options) {
  return write_event(
      options,
      Paused{.team = options.team, .why = options.reason, .by = options.by, .at = now_text()});
}

Result<int> run_resume(const RulingOptions& options) {
  return write_event(
      options,
      Resumed{.team = options.team, .why = options.reason, .by = options.by, .at = now_text()});
}

}  // namespace mirocup::league
