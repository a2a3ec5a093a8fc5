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

// How far an end's team may be from the ball, centre to centre, to contest it.
bool is_contested(const Pitch& pitch, const Situation& situation, End owner);

// A decision at the end of the tick, with the ball where it is.
Decision decide(Verdict verdict, Law law, const Situation& situation, std::string reason);

// "3.20": for reasons.
std::string fixed(double value, int decimals);

}  // namespace mirocup::referee
