// SPDX-License-Identifier: MIT
//
// Converts between a leg and the messages of FIRASim. In these messages blue is always left, so
// their frame is the blue team's own frame, whichever end blue defends.
#pragma once

#include "core/match/leg.hpp"
#include "server/firasim/wire.hpp"

namespace mirocup::firasim {

// The wheels of FIRASim's robot (config/Parsian.ini). Clients' commands are for these wheels.
inline constexpr double wheel_radius = 0.02;  // m
inline constexpr double track = 0.08;         // m

// Returns the state in blue's own frame.
Vision to_vision(const match::Leg& leg);

// Returns the speeds of this simulator's wheels, rad/s, that move a robot as FIRASim's wheels
// would. If a speed is beyond the limit, both speeds are scaled down together, so that the robot
// drives the same curve. Precondition: both speeds are finite.
simulator::WheelSpeeds to_wheels(double left, double right,
                                 const simulator::Parameters& parameters);

// Returns the poses that a placement asks for, in the team's own frame. Robots that the placement
// does not name stay.
match::PlacementRequest to_request(const TeamPlacement& placement,
                                   const match::Observation& observation);

// Return the referee's command for a restart, and for another foul such as STOP.
RefereeCommand to_command(const match::Leg& leg, const match::LoggedDecision& restart);
RefereeCommand to_command(const match::Leg& leg, Foul foul);

}  // namespace mirocup::firasim
