// SPDX-License-Identifier: MIT
//
// The knockout of a league as a picture.
#pragma once

#include "tournaments/publish/leg_view.hpp"

#include <string>

namespace mirocup::league {

// Returns an SVG element for the front page, in which each tie links to its place on the page of
// its round, and each score of a leg to its replay; "" if the league has no knockout. The score of
// a shoot-out is in brackets.
std::string bracket_svg(const Overview& overview);

}  // namespace mirocup::league
