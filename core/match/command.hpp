// SPDX-License-Identifier: MIT
//
// What a team answers to an observation: the speeds of all its wheels, and at a restart where it
// wants to stand.
//
// A command is checked once, where it enters the match: what is not finite becomes 0, what is out
// of range is clamped, both are counted; then it is rounded to the resolution of the radio. From
// there on it is a small integer, so that a record holds exactly what was driven.
#pragma once

#include "core/field/league.hpp"
#include "core/match/placement_request.hpp"
#include "core/simulator/model/state.hpp"

#include <array>
#include <cstdint>
#include <optional>

namespace mirocup::match {

// Resolution of a wheel speed, rad/s, and the largest one that a record can hold.
inline constexpr double wheel_speed_step = 1.0 / 256.0;
inline constexpr double max_wheel_speed = 127.0;

struct Command {
  std::array<simulator::WheelSpeeds, max_robots_per_team> wheels{};  // rad/s
  std::optional<PlacementRequest>
      placement;  // counts while it is the team's turn to place (Snapshot::placing)
};

// As driven and as recorded: left and right of each robot in units of wheel_speed_step.
struct DrivenCommand {
  std::array<std::array<std::int16_t, 2>, max_robots_per_team> wheels{};

  bool operator==(const DrivenCommand&) const = default;

  simulator::WheelSpeeds speeds(int robot) const {
    return {wheels[robot][0] * wheel_speed_step, wheels[robot][1] * wheel_speed_step};
  }
};

struct CheckedCommand {
  DrivenCommand command;
  int bad_values = 0;  // not finite, or out of range
};

// `limit`: of the wheel speed, rad/s.
CheckedCommand check(const Command& command, int robots, double limit);

}  // namespace mirocup::match
