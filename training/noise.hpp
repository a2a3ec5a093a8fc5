// SPDX-License-Identifier: MIT
//
// Robots that move at random, like the robots without a learner in rSoccer's VSS environment: the
// speed of each wheel is an Ornstein-Uhlenbeck process, x += theta (0 - x) dt + sigma sqrt(dt) n,
// with theta = 0.17/s and sigma = 0.5/sqrt(s), in shares of the speed limit.
#pragma once

#include "core/match/command.hpp"
#include "core/match/disturbances.hpp"

#include <array>

namespace mirocup::training {

// The random motion of a team. The class is a plain value.
class Noise {
 public:
  Noise() = default;
  // Makes the motion of one team in the episode of `seed`.
  Noise(std::uint64_t seed, Team team);

  // Returns the wheel speeds of all robots for a tick of `period` seconds; `limit` is in rad/s.
  match::Command next(int robots, double period, double limit);

 private:
  Random random_;
  std::array<std::array<double, 2>, max_robots_per_team> share_{};
};

}  // namespace mirocup::training
