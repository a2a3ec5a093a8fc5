// SPDX-License-Identifier: MIT
#include "record/statistics/statistics.hpp"

#include <functional>
#include <numeric>

namespace mirocup::statistics {

namespace {

template <std::size_t n>
int sum(const std::array<int, n>& numbers) {
  return std::accumulate(numbers.begin(), numbers.end(), 0);
}

template <std::size_t n>
void add(std::array<int, n>& to, const std::array<int, n>& numbers) {
  std::transform(to.begin(), to.end(), numbers.begin(), to.begin(), std::plus<>());
}

}  // namespace

int TeamStatistics::all_goals() const {
  return sum(goals);
}

int TeamStatistics::all_losses() const {
  return sum(losses);
}

int TeamStatistics::all_fouls() const {
  return sum(fouls);
}

TeamStatistics& TeamStatistics::operator+=(const TeamStatistics& other) {
  add(goals, other.goals);
  shots += other.shots;
  shots_on_goal += other.shots_on_goal;
  saves += other.saves;
  passes += other.passes;
  interceptions += other.interceptions;
  add(losses, other.losses);
  duels_won += other.duels_won;
  add(fouls, other.fouls);
  possession_s += other.possession_s;
  opponent_half_s += other.opponent_half_s;
  distance_m += other.distance_m;
  return *this;
}

std::optional<double> share(double one, double other) {
  if (!(one + other > 0.0)) return std::nullopt;
  return one / (one + other);
}

}  // namespace mirocup::statistics
