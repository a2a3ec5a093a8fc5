// SPDX-License-Identifier: MIT
//
// Reads any bytes as what a team sends over FIRASim's protocol: commands and placements. What is
// read has bounds, and becomes wheels that a robot can drive.
#include "server/firasim/convert.hpp"
#include "tests/security/fuzz/fuzz_target.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

MIROCUP_FUZZ_TARGET(firasim) {
  using namespace mirocup;
  using namespace mirocup::firasim;
  const simulator::Parameters parameters;
  if (const auto packet = decode_packet(fuzz::text_of(data, size))) {
    if (packet->commands.size() > max_entries) std::abort();
    for (const WheelCommand& command : packet->commands) {
      if (!std::isfinite(command.left) || !std::isfinite(command.right)) continue;
      const auto wheels = to_wheels(command.left, command.right, parameters);
      const double fastest = std::max(std::abs(wheels.left), std::abs(wheels.right));
      if (!(fastest <= parameters.wheel_speed_limit)) std::abort();
    }
  }
  if (const auto placement = decode_placement(fuzz::text_of(data, size))) {
    if (placement->robots.size() > max_entries) std::abort();
    match::Observation observation;
    observation.robots = max_robots_per_team;
    (void)to_request(*placement, observation);
  }
}
