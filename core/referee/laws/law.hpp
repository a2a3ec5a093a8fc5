// SPDX-License-Identifier: MIT
//
// What every law is given. A law's file has four parts in this order: its source, what it
// remembers, when it applies, what it decides. Laws see situations, never a simulated world.
#pragma once

#include "core/referee/decision.hpp"
#include "core/referee/rules.hpp"
#include "core/referee/situation.hpp"

#include <optional>

namespace mirocup::referee {

// Where and with what is played. Metres.
struct Pitch {
  const field::Field& field;
  const Rules& rules;
  double ball_radius = 0.0;
  double robot_side = 0.0;
};

// Both ends, the one first in whose half the ball is: when two teams offend in one tick, neither
// end has an advantage.
std::array<End, 2> ends_from_ball(const Situation& situation);

// Is an opponent of the owner near enough to the ball, centre to centre, to contest it?
bool is_contested(const Pitch& pitch, const Situation& situation, End owner);

// Does a's command take it towards b?
bool drives_at(const Pitch& pitch, const Situation& situation, const RobotId& a, const RobotId& b);

// Is the ball where a crowd before that end's goal matters: in the penalty area, or where there is
// none, in or close to the goal area?
bool ball_in_zone(const Pitch& pitch, const Situation& situation, End end);

// Is the ball in that end's half?
bool ball_in_half(const Situation& situation, End end);

// A decision at the end of the tick, with the ball where it is.
Decision decide(Verdict verdict, Law law, const Situation& situation, std::string reason);

// Gives a restart to one end, against the other.
Decision against(Decision decision, End offender, Restart restart);

// A free ball in the quarter of that point, which nobody is to blame for.
void give_free_ball(const Pitch& pitch, const Vec2& where, Decision& decision);

// The quarter of a point, as the signs of its coordinates; 0 counts as negative.
struct Quarter {
  double x = 1.0;
  double y = 1.0;
};
Quarter quarter_of(const Vec2& point);

// "3.20", and "left robot 2": for reasons.
std::string fixed(double value, int decimals);
std::string name_of(const RobotId& robot);

}  // namespace mirocup::referee
