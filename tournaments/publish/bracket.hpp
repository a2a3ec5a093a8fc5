// SPDX-License-Identifier: MIT
//
// The knockout as a picture, and the whole schedule as the tables of brackets-model, which other
// programs draw.
#pragma once

#include "tournaments/league/league_state.hpp"

#include <string>

namespace mirocup::league {

// An SVG to stand in a page; "" if the league has no knockout. Ties link to "#ID".
std::string bracket_svg(const LeagueState& state);

Json bracket_json(const LeagueState& state);

}  // namespace mirocup::league
