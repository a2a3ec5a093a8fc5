// SPDX-License-Identifier: MIT
//
// The schedule of a league that is being played: who takes a place in the knockout, the next round
// of a Swiss tournament, the fixtures of a new entry. Called after every change of a result.
#pragma once

#include "tournaments/league/league_state.hpp"

namespace mirocup::league {

class ScheduleGrowth {
 public:
  explicit ScheduleGrowth(LeagueState& state) : state_(state) {}

  // Adds fixtures at the end.
  void add(const std::vector<Fixture>& fixtures);

  // After anything happened to that fixture.
  void fixture_changed(int fixture);

  // After a team left or came back, or its entry changed.
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
