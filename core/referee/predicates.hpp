// SPDX-License-Identifier: MIT
//
// Questions about a situation that several laws ask.
#pragma once

#include "core/referee/judged_field.hpp"
#include "core/referee/tick_facts.hpp"

#include <array>

namespace mirocup::referee {

// Returns both ends, first the end in whose half the ball is. Laws test the ends in this order, so
// that no end is favoured when both teams offend in one tick.
std::array<End, 2> ends_from_ball(const TickFacts& situation);

// True if the ball is in that end's half; false for both ends when it is on the half line.
bool ball_in_half(const TickFacts& situation, End end);

// True if the ball is in the zone of that end's goal. If Rules::zone_depth_m is above 0, that depth
// and zone_half_width_m bound the zone. If it is 0, the zone is the penalty area or, on a field
// without penalty areas, the goal area and zone_margin_m around it.
bool ball_in_zone(const JudgedField& pitch, const TickFacts& situation, End end);

// True if the centre of an opponent of `owner` is within `contested_m` of the ball's centre.
bool is_contested(const JudgedField& pitch, const TickFacts& situation, End owner);

// True if the commanded velocity of `a` has a component of at least `drive_mps` towards `b`.
bool drives_at(const JudgedField& pitch, const TickFacts& situation, const RobotId& a,
               const RobotId& b);

}  // namespace mirocup::referee
