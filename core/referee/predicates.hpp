// SPDX-License-Identifier: MIT
//
// Questions about a situation that several laws ask.
#pragma once

#include "core/referee/pitch.hpp"
#include "core/referee/situation.hpp"

#include <array>

namespace mirocup::referee {

// Returns both ends, first the end in whose half the ball is. Laws test the ends in this order, so
// that no end is favoured when both teams offend in one tick.
std::array<End, 2> ends_from_ball(const Situation& situation);

// True if the ball is in that end's half; false for both ends when it is on the half line.
bool ball_in_half(const Situation& situation, End end);

// True if the ball is where a crowd in front of that end's goal matters: in the penalty area or, on
// a field without one, in the goal area or within `zone_margin_m` of it.
bool ball_in_zone(const Pitch& pitch, const Situation& situation, End end);

// True if the centre of an opponent of `owner` is within `contested_m` of the ball's centre.
bool is_contested(const Pitch& pitch, const Situation& situation, End owner);

// True if the commanded velocity of `a` has a component of at least `drive_mps` towards `b`.
bool drives_at(const Pitch& pitch, const Situation& situation, const RobotId& a, const RobotId& b);

}  // namespace mirocup::referee
