// SPDX-License-Identifier: MIT
//
// The answer of a team to an observation: the speeds of all its wheels and, at a restart, the
// places that it asks for.
//
// A command is checked once, where it enters the leg. A speed that is not finite becomes 0, a speed
// out of range is clamped, and both are counted; then each speed is rounded to the resolution of
// the radio. From there on it is a small integer, so that a record holds exactly what was driven.
#pragma once

#include "core/field/league.hpp"
#include "core/match/placement_request.hpp"
#include "core/simulator/model/state.hpp"

#include <array>
#include <cstdint>
#include <optional>

namespace mirocup::match {

// The resolution of a wheel speed and the largest wheel speed that a record can hold, rad/s.
inline constexpr double wheel_speed_step = 1.0 / 256.0;
inline constexpr double max_wheel_speed = 127.0;

// A command as the team gave it.
struct Command {
  std::array<simulator::WheelSpeeds, max_robots_per_team> wheels{};  // rad/s
  // Counts only in the team's turn to place (Snapshot::placing).
  std::optional<PlacementRequest> placement;
};

// A command as it is driven and recorded: left and right wheel of each robot, in units of
// wheel_speed_step.
struct DrivenCommand {
  std::array<std::array<std::int16_t, 2>, max_robots_per_team> wheels{};

  bool operator==(const DrivenCommand&) const = default;

  simulator::WheelSpeeds speeds(int robot) const {
    return {wheels[robot][0] * wheel_speed_step, wheels[robot][1] * wheel_speed_step};
  }
};

struct CheckedCommand {
  DrivenCommand command;
  int bad_values = 0;  // speeds that were not finite, or out of range
};

// Checks the commands of the first `robots` robots. `limit` is the largest allowed wheel speed,
// rad/s; it is at most max_wheel_speed.
CheckedCommand check(const Command& command, int robots, double limit);

}  // namespace mirocup::match
