// SPDX-License-Identifier: MIT
//
// Converts between a leg and the messages of FIRASim. Blue is left on the wire, so the frame there
// is the blue team's own frame, at whichever end blue plays.
#pragma once

#include "core/match/leg.hpp"
#include "server/firasim/wire.hpp"

namespace mirocup::firasim {

// The wheels of FIRASim's robot (config/Parsian.ini), to which the commands of its clients refer.
inline constexpr double wheel_radius = 0.02;  // m
inline constexpr double track = 0.08;         // m

// Returns the state as blue sees it.
Vision to_vision(const match::Leg& leg);

// Returns the speeds of this simulator's wheels that move a robot as FIRASim's wheels would; rad/s,
// if one is beyond the limit, both are scaled down together, so that the curve stays. Precondition:
// both speeds are finite.
simulator::WheelSpeeds to_wheels(double left, double right,
                                 const simulator::Parameters& parameters);

// Returns the poses that a placement asks for, in the team's own frame; robots that it does not
// name stay.
match::PlacementRequest to_request(const TeamPlacement& placement,
                                   const match::Observation& observation);

// Returns the referee's command for a restart, and for another foul such as STOP.
RefereeCommand to_command(const match::Leg& leg, const match::LoggedDecision& restart);
RefereeCommand to_command(const match::Leg& leg, Foul foul);

}  // namespace mirocup::firasim
