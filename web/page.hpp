// SPDX-License-Identifier: MIT
//
// The page that shows a leg in a browser: one HTML text that needs nothing else. A replay page
// contains the whole leg; a live page gets the leg from its server.
#pragma once

#include "core/replay/playback.hpp"
#include "record/match_record.hpp"
#include "record/own_texts.hpp"
#include "record/statistics/statistics.hpp"
#include "web/page_parts.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace mirocup::web {

// Whether the page shows times that a clock measured. They differ each time that the leg is played;
// a page without them has the same bytes on every machine.
enum class Times { shown, left_out };

// Simulates the leg again to get the positions, and returns the data that page/main.js reads: the
// schema "mirocup/page/1". The error is the first tick in which the record is not reproduced.
tl::expected<record::Json, replay::Divergence> replay_data(const record::MatchRecord& record,
                                                           Times times = Times::shown);

// Returns the data in a page of replay_page(), also in a page of an earlier version. `html` may be
// any text; if it has no such data, returns nothing.
std::optional<record::Json> data_of_page(std::string_view html);

// Returns the first moment of the leg as an SVG element, whose bodies page/field.js moves.
std::string first_picture(const record::MatchRecord& record);

// How a visitor's browser can simulate the leg again. It needs the module of this program, and the
// commands of both teams.
struct Proof {
  std::optional<BrowserModule> module = {};  // in the page, unless it is a file
  std::string module_file = "";    // address of module_file(), seen from the page; "": it is none
  std::string commands_file = "";  // that of commands_script(); "": the page has the commands
};

// Whether a page shows what only the teams may see of each robot: the speeds that its wheels were
// asked for and had, and the age of the picture by which its team saw it.
enum class Wheels { shown, left_out };

struct ReplayPage {
  std::string html;
  statistics::LegStatistics statistics;  // the statistics on the page
  std::size_t proof_size = 0;            // bytes of the page for the proof of the leg
};

// Returns the page of the leg, with its data. Between the comments <!--league--> and <!--/league-->
// a league may put links to its other pages. For a page that others may see, leave out `own`.
// Without `proof`, or without a module for it, nobody can prove the page.
tl::expected<ReplayPage, replay::Divergence> replay_page(const record::MatchRecord& record,
                                                         Times times = Times::shown,
                                                         const record::OwnTexts& own = {},
                                                         const std::optional<Proof>& proof = {},
                                                         Wheels wheels = Wheels::left_out);

// Returns the script file that gives a page of this record the commands of both teams.
std::string commands_script(const record::MatchRecord& record);

// The data of a live page besides the match.
struct LiveMatch {
  match::ByTeam<std::string> names;
  std::string about;   // a line for the foot of the page
  std::string events;  // URL of the events, relative to the page
};

std::string live_page(const match::Leg& match, const LiveMatch& live);

}  // namespace mirocup::web
