// SPDX-License-Identifier: MIT
//
// Roles: the tasks of the robots. A role goes to the robot with the least cost. The robot that had
// the role in the last tick keeps it unless another robot is clearly better, because robots that
// always change places achieve nothing.
//
//   cheapest_robot   the robot that takes one role
//   time_behind      the cost of attacking: the time until a robot is behind the ball
//   assign_places    the robots for several places
//
// Frames and units are those of strategy.h.
#pragma once

#include "mirocup/skills/intercept.hpp"

#include <array>
#include <span>

namespace mirocup::strategy {

// Returns the number of the robot with the least cost, of robots `first` and higher. `cost(i)` is
// the cost of robot i; robot `last` costs `bonus` less.
template <class Cost>
int cheapest_robot(const Observation& now, int first, int last, double bonus, const Cost& cost) {
  int best = first;
  double least = 1e9;
  for (int i = first; i < now.robots; ++i) {
    const double c = cost(i) - (i == last ? bonus : 0.0);
    if (c >= least) continue;
    best = i;
    least = c;
  }
  return best;
}

// Returns the time, s, after which a robot meets the ball on its path, plus `round_s` if the robot
// has to drive round the ball.
inline double time_behind(const BallPath& path, const Robot& robot, double round_s = 0.35) {
  const Interception meet = intercept(path, robot);
  return meet.seconds + (robot.x > meet.ball.at.x - 0.03 ? round_s : 0.0);
}
inline double time_behind(const Setup& setup, const Observation& now, int i,
                          double round_s = 0.35) {
  return time_behind(BallPath(setup, moving_ball(now)), now.own[i], round_s);
}

// For each place, the number of the robot that takes it.
using Assignment = std::array<int, MIROCUP_MAX_ROBOTS>;

// Gives each place, the most important first, to the nearest robot that is still free. `free` are
// the robots to choose from, as many as places. `last` is the assignment of the last tick, by
// place; the last robot of a place counts as `bonus` m nearer to the place.
inline Assignment assign_places(const Observation& now, std::span<const Point> places,
                                std::span<const int> free, const Assignment& last,
                                double bonus = 0.1) {
  Assignment chosen{};
  std::array<bool, MIROCUP_MAX_ROBOTS> is_taken{};
  for (std::size_t k = 0; k < places.size(); ++k) {
    double least = 1e9;
    for (const int i : free) {
      if (is_taken[i]) continue;
      const double distance = length(places[k] - position(now.own[i]));
      const double cost = distance - (last[k] == i ? bonus : 0.0);
      if (cost >= least) continue;
      least = cost;
      chosen[k] = i;
    }
    is_taken[chosen[k]] = true;
  }
  return chosen;
}

}  // namespace mirocup::strategy
