// SPDX-License-Identifier: MIT
//
// The page of one team: its rank, form, statistics, faults and legs.
#pragma once

#include "tournaments/publish/league_statistics.hpp"
#include "tournaments/publish/leg_view.hpp"

#include <string>

namespace mirocup::league {

// Returns the path of the team's page inside site/.
std::string team_page_of(const std::string& team);

// Returns the page of the team with that index.
std::string team_html(const Overview& overview, const LegReports& reports, int team);

}  // namespace mirocup::league
