// SPDX-License-Identifier: MIT
//
// Functions that make decisions, shared by the laws, the placement and the referee.
#pragma once

#include "core/referee/decision.hpp"
#include "core/referee/judged_field.hpp"

#include <string>

namespace mirocup::referee {

// Returns a decision at the end of the situation's tick, with the ball where it is then. It has no
// team and no restart yet.
Decision decide(Verdict verdict, Law law, const TickFacts& situation, std::string reason);

// Returns the decision with `offender` as its team and a restart that the other team takes.
Decision against(Decision decision, End offender, Restart restart);

// Makes the restart of a decision a free ball in the quarter of the point `where`. Its team stays
// as it is: a free ball need not be the fault of a team.
void give_free_ball(const JudgedField& pitch, const Vec2& where, Decision& decision);

// Texts for reasons: "3.20" with two decimals, "left robot 2".
std::string fixed(double value, int decimals);
std::string name_of(const RobotId& robot);

}  // namespace mirocup::referee
