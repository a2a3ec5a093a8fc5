// SPDX-License-Identifier: MIT
//
// The league as a folder of pages that work without a server, and as files for other programs. Its
// content is a pure function of the league's state: the same results give the same bytes, in
// whatever order and on whatever machine the legs were played.
#pragma once

#include "tournaments/league/league_state.hpp"
#include "tournaments/publish/league_statistics.hpp"
#include "tournaments/publish/site_file.hpp"

#include <string>
#include <vector>

namespace mirocup::league {

// Returns index.html, a page for each team below teams/, and the files of exports() and
// statistics_exports(). Replay pages, and with them the statistics of each leg, are made by
// make_replay_pages().
std::vector<SiteFile> make_site(const LeagueState& state, const LegReports& reports = {});

// Returns the table as lines of text for a terminal.
std::string table_text(const LeagueState& state);

}  // namespace mirocup::league
