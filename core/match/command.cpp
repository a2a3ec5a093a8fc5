// SPDX-License-Identifier: MIT
#include "core/match/command.hpp"

#include "core/base/assert.hpp"

#include <algorithm>
#include <cmath>

namespace mirocup::match {

CheckedCommand check(const Command& command, int robots, double limit) {
  MIROCUP_ASSERT(0 <= robots && robots <= max_robots_per_team);
  MIROCUP_ASSERT(0.0 <= limit && limit <= max_wheel_speed);
  CheckedCommand result;
  const auto driven = [&](double speed) -> std::int16_t {
    if (!std::isfinite(speed)) {
      ++result.bad_values;
      return 0;
    }
    const double clamped = std::clamp(speed, -limit, limit);
    if (clamped != speed) ++result.bad_values;
    return static_cast<std::int16_t>(std::nearbyint(clamped / wheel_speed_step));
  };
  for (int i = 0; i < robots; ++i) {
    result.command.wheels[i] = {driven(command.wheels[i].left), driven(command.wheels[i].right)};
  }
  return result;
}

}  // namespace mirocup::match
