// SPDX-License-Identifier: MIT
//
// Extends the schedule of a league while it is played: fills places in the knockout, pairs the next
// round of a Swiss tournament and adds the fixtures of a new ladder entry. apply() calls it after
// every event that changes a result or a team.
#pragma once

#include "tournaments/league/league_state.hpp"

namespace mirocup::league {

class ScheduleGrowth {
 public:
  explicit ScheduleGrowth(LeagueState& state) : state_(state) {}

  // Appends fixtures to the schedule.
  void add(const std::vector<Fixture>& fixtures);

  // Must be called after a result of that fixture changed.
  void fixture_changed(int fixture);

  // Must be called after a team withdrew, with `annul` if its results count for nothing, and after
  // an entry of a team was booked.
  void team_left(int team, bool annul);
  void entry_booked(int team);

 private:
  void count(int fixture);
  void give_walkover(int fixture);
  void fill_places();
  void pair_swiss();
  void remove_last();
  std::optional<int> team_of(const TeamSource& source) const;

  LeagueState& state_;
};

}  // namespace mirocup::league
