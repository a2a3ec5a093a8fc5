// SPDX-License-Identifier: MIT
//
// The statistics of a leg for spectators: possession, shots, distances, a heat map of the ball.
#pragma once

#include "core/match/leg.hpp"

#include <array>
#include <vector>

namespace mirocup::web {

struct TeamStatistics {
  double possession = 0.0;  // s of play since this team was the last to touch the ball
  int shots = 0;
  std::array<double, max_robots_per_team> distance{};  // of each robot in play, m
};

class Statistics {
 public:
  explicit Statistics(const field::Field& field);

  // To be called after every tick, in order; also before the first tick.
  void add(const match::Leg& match);

  const TeamStatistics& of(Team team) const { return teams_[index_of(team)]; }

  // The ticks of play that the ball spent in each cell of the field, which is turned so that blue
  // attacks to the right. Rows from the top, each of columns() cells.
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
