// SPDX-License-Identifier: MIT
//
// The schedule of a league for other programs that draw brackets.
#pragma once

#include "tournaments/league/league_state.hpp"

namespace mirocup::league {

// Returns the fixtures as the tables of brackets-model (npm), which brackets-viewer draws: the keys
// "participant", "stage", "group", "round", "match" and "match_game", each with a list of rows. In
// these tables a fixture is a match, and a leg is a match game.
Json bracket_json(const LeagueState& state);

}  // namespace mirocup::league
