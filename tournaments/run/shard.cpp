// SPDX-License-Identifier: MIT
#include "tournaments/run/shard.hpp"

#include "tournaments/run/leg_command.hpp"
#include "tournaments/run/process_set.hpp"

#include <nlohmann/json.hpp>

namespace mirocup::league {

namespace {

// The legs that can be played now: what decides a tie waits for the others to be booked.
std::vector<int> open_legs(const LeagueState& state, const FixtureState& f) {
  if (!f.fixture.has_both()) return {};
  for (const int team : {f.fixture.home, f.fixture.away}) {
    if (state.teams[team].standing != Standing::playing || state.file.teams[team].over_dds)
      return {};
  }
  std::vector<int> legs;
  for (int leg = 1; leg <= f.needed(); ++leg) {
    if (!f.legs[leg - 1].played) legs.push_back(leg);
  }
  return legs;
}

}  // namespace

std::vector<std::string> open_shards(const LeagueState& state) {
  std::vector<std::string> ids;
  for (const FixtureState& f : state.fixtures) {
    if (!open_legs(state, f).empty()) ids.push_back(f.fixture.id());
  }
  return ids;
}

Result<int> run_shard(record::Files& files, const Book& book, const std::string& id) {
  const LeagueState& state = book.state();
  if (!state.is_started) {
    return fail(Errc::input,
                book.folder().path + " has not started: mirocup league plan does that");
  }
  const auto index = state.find_fixture(id);
  if (!index) return fail(Errc::input, "there is no fixture " + id);
  const FixtureState& f = state.fixtures[*index];
  int failed = 0;
  for (const int leg : open_legs(state, f)) {
    const LegId what{f.fixture, leg, f.legs[leg - 1].version};
    if (played_record(files, book.folder(), state, what)) continue;
    ProcessSet processes;
    const auto started =
        processes.start(leg_command(book.folder(), state, what, id), 0, -1,
                        book.folder().record(f.fixture, leg, what.version) + ".out");
    if (!started) return tl::unexpected(started.error());
    const auto exit = processes.wait();
    if (!exit) return fail(Errc::interrupted, "interrupted; the same command goes on from here");
    if (!played_record(files, book.folder(), state, what)) ++failed;
  }
  return failed;
}

}  // namespace mirocup::league
