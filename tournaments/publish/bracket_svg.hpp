// SPDX-License-Identifier: MIT
//
// The knockout of a league as a picture.
#pragma once

#include "tournaments/league/league_state.hpp"

#include <string>

namespace mirocup::league {

// Returns an SVG element for a page, in which each tie links to "#ID" of its fixture; "" if the
// league has no knockout.
std::string bracket_svg(const LeagueState& state);

}  // namespace mirocup::league
