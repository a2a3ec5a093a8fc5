// SPDX-License-Identifier: MIT
//
// The placement that a team requests at a restart: places for its robots and, where it has the
// choice, for the ball. In the team's own frame: metres, radians counter-clockwise.
//
// Like a command, a request is input from outside: it may hold any number, infinities and NaN
// included. Like a command it is rounded once, where it enters the leg, so that the last bits of a
// team's arithmetic reach neither the state nor the record.
#pragma once

#include "core/field/league.hpp"
#include "core/field/team.hpp"
#include "core/referee/placement.hpp"

#include <array>

namespace mirocup::match {

struct Observation;

// One robot's place.
struct RequestedPose {
  double x = 0.0;
  double y = 0.0;
  double heading = 0.0;
};

// The places of all robots of a team, and of the ball.
struct PlacementRequest {
  double ball_x = 0.0;
  double ball_y = 0.0;
  std::array<RequestedPose, max_robots_per_team> robots;
};

// Returns the request that changes nothing: everything stays where it is observed.
PlacementRequest unchanged_request(const Observation& observation);

// True if a and b hold the same numbers, bit for bit; unlike with ==, NaN equals itself. `robots`
// is the number of robots compared.
bool bit_equal(double a, double b);
bool bit_equal(const RequestedPose& a, const RequestedPose& b);
bool bit_equal(const PlacementRequest& a, const PlacementRequest& b, int robots);

// The resolution of a request, m and rad: far below the tolerance of every rule of placement.
inline constexpr double placement_step = 0x1p-24;

// Returns the request with the ball's place and each pose rounded to multiples of placement_step,
// unless they equal those `shown` to the team. `robots` is the number of robots of the team.
PlacementRequest rounded(const PlacementRequest& asked, const PlacementRequest& shown, int robots);

// Returns the placement, in the field's frame, in which the team of one end stands as requested and
// all other bodies as in `standing`. A body for which the team asks the pose that was `shown` to it
// keeps the bits of its pose in `standing`, so an unchanged request moves no body by a rounding
// error. A heading that is not finite or is too large makes a pose of NaNs, which no check accepts.
referee::Placement requested_placement(const referee::Placement& standing, End end,
                                       const PlacementRequest& shown, const PlacementRequest& asked,
                                       int robots);

}  // namespace mirocup::match
