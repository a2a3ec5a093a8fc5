// SPDX-License-Identifier: MIT
//
// What spectators ask about a leg in numbers: who had the ball, how far they drove, what they tried.
#pragma once

#include "core/match/leg.hpp"

#include <array>
#include <vector>

namespace mirocup::web {

struct TeamStatistics {
  double possession = 0.0;  // s of play in which this team was the last to touch the ball
  int shots = 0;
  std::array<double, max_robots_per_team> distance{};  // m, of each robot, in play
};

class Statistics {
 public:
  explicit Statistics(const field::Field& field);

  // After every tick, in order; the first call may be before the first tick.
  void add(const match::Leg& match);

  const TeamStatistics& of(Team team) const { return teams_[index_of(team)]; }

  // Ticks of play that the ball spent in each cell of the field, turned so that blue attacks to the
  // right; rows from the top, `columns()` cells each.
  const std::vector<int>& heat() const { return heat_; }
  int columns() const { return columns_; }

 private:
  void count_distance(const match::Snapshot& scene);
  void count_possession(const match::Leg& match, double period);
  void count_shots(const match::Snapshot& scene);
  void count_heat(const match::Snapshot& scene);

  field::Field field_;
  int columns_;
  int rows_;
  match::ByTeam<TeamStatistics> teams_;
  std::vector<int> heat_;
  std::optional<match::Snapshot> before_;
  std::optional<Team> holder_;
  bool is_shot_counted_ = false;
};

}  // namespace mirocup::web
