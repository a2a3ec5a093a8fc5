// SPDX-License-Identifier: MIT
#include "tournaments/play/shard.hpp"

#include "system/process_set.hpp"
#include "tournaments/play/leg_command.hpp"
#include "tournaments/play/leg_record.hpp"

namespace mirocup::league {

namespace {

// True if a team joins what `league start` or people have started on this host.
bool joins_from_outside(const LeagueState& state, const Fixture& fixture) {
  const auto joins = [&](int team) {
    const TeamConfig& config = state.file.teams[team];
    return config.over_dds || config.is_started_by_people();
  };
  return joins(fixture.home) || joins(fixture.away);
}

// Plays legs one after the other until an interrupt.
class Shard {
 public:
  Shard(system::Files& files, const LeagueStore& store) : files_(files), store_(store) {}

  // False if the leg could not be played.
  Result<bool> play(const LegId& leg) {
    const auto before = is_played(leg);
    if (!before || *before) return before;
    if (processes_.is_asked_to_stop_within(0.0)) return stopped();
    const Folder& folder = store_.folder();
    MIROCUP_TRY_VOID(processes_.start(leg_command(folder, store_.state(), leg, leg.fixture.id()), 0,
                                      -1, leg_output(folder, leg)));
    if (!processes_.wait()) {
      (void)processes_.wait();
      return stopped();
    }
    return is_played(leg);
  }

 private:
  static tl::unexpected<Error> stopped() {
    return fail(Errc::interrupted, "interrupted; the same command continues from here");
  }

  Result<bool> is_played(const LegId& leg) const {
    return find_played_leg(files_, store_.folder(), store_.state(), leg)
        .map([](const std::optional<LegPlayed>& played) { return played.has_value(); });
  }

  system::Files& files_;
  const LeagueStore& store_;
  system::ProcessSet processes_;
};

}  // namespace

std::vector<std::string> open_shards(const LeagueState& state) {
  std::vector<std::string> ids;
  for (const FixtureState& f : state.fixtures) {
    if (!open_legs(state, f).empty() && !joins_from_outside(state, f.fixture))
      ids.push_back(f.fixture.id());
  }
  return ids;
}

Result<int> play_shards(system::Files& files, const LeagueStore& store,
                        const std::vector<std::string>& fixtures) {
  const LeagueState& state = store.state();
  if (!state.is_started)
    return fail(Errc::input,
                store.folder().path + " has not started: mirocup league plan starts it");
  Shard shard(files, store);
  int failed = 0;
  for (const std::string& id : fixtures) {
    const auto index = state.find_fixture(id);
    if (!index) return fail(Errc::input, "there is no fixture " + id);
    const FixtureState& f = state.fixtures[*index];
    if (f.fixture.has_both() && joins_from_outside(state, f.fixture))
      return fail(Errc::input, id + " has a team over the network: league start plays it");
    for (const int leg : open_legs(state, f)) {
      MIROCUP_TRY(const auto played, shard.play({f.fixture, leg, f.legs[leg - 1].version}));
      if (!played) ++failed;
    }
  }
  return failed;
}

}  // namespace mirocup::league
