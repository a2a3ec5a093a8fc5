// SPDX-License-Identifier: MIT
//
// The league as a folder of pages that work without a server, and as files for other programs. Its
// content is a pure function of the league's state: the same results give the same bytes, in
// whatever order and on whatever machine the legs were played.
#pragma once

#include "tournaments/publish/league_statistics.hpp"
#include "tournaments/publish/leg_view.hpp"
#include "tournaments/publish/night.hpp"
#include "tournaments/publish/site_file.hpp"

#include <string>
#include <vector>

namespace mirocup::league {

// Returns index.html, crosstable.html, a page for each round below rounds/ and for each team below
// teams/, the style sheet and the script of these pages, and the files of exports() and
// statistics_exports(). `reports` and `facts` are of the legs that were played; pages say less
// without them. Replay pages, and with them the statistics of each leg, are made by
// make_replay_pages().
// `night`, if not null, adds night.html and digests/; `feed`, if not "", is feed.xml.
std::vector<SiteFile> make_site(const LeagueState& state, const LegReports& reports = {},
                                const FactsOfLegs& facts = no_facts, const Night* night = nullptr,
                                const std::string& feed = "");

// Returns the table as lines of text for a terminal.
std::string table_text(const LeagueState& state);

}  // namespace mirocup::league
