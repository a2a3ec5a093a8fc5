// SPDX-License-Identifier: MIT
//
// Keeps the schedule of a league up to date while it is played: teams that take their places in the
// knockout, the next round of a Swiss tournament, the fixtures of a new entry of a ladder, teams
// that join. It also keeps the counts of LeagueState, so every change of a result must be reported
// to it.
#pragma once

#include "tournaments/league/league_state.hpp"

namespace mirocup::league {

class ScheduleGrowth {
 public:
  explicit ScheduleGrowth(LeagueState& state) : state_(state) {}

  // Appends fixtures to the schedule.
  void add(const std::vector<Fixture>& fixtures);

  // To be called after a leg of the fixture with that index has changed; with no_fixture, after
  // teams have left.
  void fixture_changed(int fixture);

  // Appends a team, which has no entry yet.
  void team_joined(const TeamJoined& joined);

  // To be called after a team has withdrawn, and after a new entry of a team was booked. `annul`:
  // the legs of the team outside a knockout count for nothing.
  void team_left(int team, bool annul);
  void entry_booked(int team);

  // To be called when a night has begun, after its entries were booked.
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
