// SPDX-License-Identifier: MIT
//
// The referee's calls in words for people: who gained, who offended, and why.
#pragma once

#include "core/match/leg.hpp"

#include <string>
#include <string_view>

namespace mirocup::match {

// Returns the reason with the colours of the teams where the referee, which knows ends only, says
// "left" and "right": "left robot 2" is "yellow robot 2" if yellow defends the left end.
std::string in_colours(std::string_view reason, Team left);

// Returns a call as one line: "Penalty kick for striker – chaser 2 pushed striker 1 0.11 m",
// "Goal for striker, 2 : 1 – own goal of chaser 0: the ball crossed the line of chaser's goal at
// y = 0.05 m". `score` is the score after the call. Teams of one name are told apart by colour.
std::string call_text(const LoggedDecision& call, const ByTeam<std::string>& names,
                      const ByTeam<int>& score);

}  // namespace mirocup::match
