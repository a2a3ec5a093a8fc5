// SPDX-License-Identifier: MIT
//
// Updates the schedule of a league while the league is played: the teams of the knockout, the next
// round of a Swiss tournament, the fixtures of a new entry of a ladder, teams that join. This class
// also updates the counts of LeagueState, so callers must report to it every change of a result.
#pragma once

#include "tournaments/league/league_state.hpp"

namespace mirocup::league {

class ScheduleGrowth {
 public:
  explicit ScheduleGrowth(LeagueState& state) : state_(state) {}

  // Appends fixtures to the schedule.
  void add(const std::vector<Fixture>& fixtures);

  // To be called after a leg of a fixture has changed, with the index of the fixture; also after
  // teams have left, with no_fixture.
  void fixture_changed(int fixture);

  // Appends a team, which has no entry yet.
  void team_joined(const TeamJoined& joined);

  // To be called after a team has withdrawn, and after a new entry of a team was booked. If
  // `annul`, the legs of the team outside a knockout count for nothing.
  void team_left(int team, bool annul);
  void entry_booked(int team);

  // To be called after a night has begun and the entries of the night were booked.
  void night_began(int number);

 private:
  static constexpr int no_fixture = -1;

  void count(int fixture);
  void give_walkover(int fixture);
  void fill_places(int changed);
  void pair_swiss();
  void remove_last();
  std::optional<int> team_of(const TeamSource& source) const;

  LeagueState& state_;
};

}  // namespace mirocup::league
