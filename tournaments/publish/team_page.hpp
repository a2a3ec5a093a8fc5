// SPDX-License-Identifier: MIT
//
// The page of one team: its rank, form, strength, best and worst legs, faults and all legs.
#pragma once

#include "tournaments/publish/front_page.hpp"

#include <string>

namespace mirocup::league {

// Returns the page of a team. `team` is its index in the league.
std::string team_html(const SiteContent& content, int team);

}  // namespace mirocup::league
