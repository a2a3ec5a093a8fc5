// SPDX-License-Identifier: MIT
//
// Where a team asks to stand at a restart, in its own frame: metres, radians counter-clockwise.
//
// Like a command it is input from outside: any number may be in it, and it is kept as it came, so
// that a recorded leg can be played again without the team.
#pragma once

#include "core/field/league.hpp"
#include "core/field/team.hpp"
#include "core/referee/placement.hpp"

#include <array>

namespace mirocup::match {

struct Observation;
struct Snapshot;

struct RequestedPose {
  double x = 0.0;
  double y = 0.0;
  double heading = 0.0;
};

struct PlacementRequest {
  double ball_x = 0.0;
  double ball_y = 0.0;
  std::array<RequestedPose, max_robots_per_team> robots;
};

// What a team asks for that asks for nothing: everything where it is.
PlacementRequest unchanged_request(const Observation& observation);

// The same numbers, bit for bit: what is not a number equals itself.
bool bit_equal(double a, double b);
bool bit_equal(const RequestedPose& a, const RequestedPose& b);
bool bit_equal(const PlacementRequest& a, const PlacementRequest& b, int robots);

// The scene with what one team asks for in it, in the field's frame. What is as it was `shown`
// stays bit for bit. A heading that is no angle makes a pose that is nowhere.
referee::Placement requested_placement(const Snapshot& scene, Team team,
                                       const PlacementRequest& shown, const PlacementRequest& asked,
                                       int robots);

}  // namespace mirocup::match
