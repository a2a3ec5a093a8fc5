// SPDX-License-Identifier: MIT
//
// The page that shows a leg in a browser: one HTML text that needs nothing else. A replay page
// contains the whole leg; a live page gets the leg from its server.
#pragma once

#include "core/replay/playback.hpp"
#include "record/match_record.hpp"
#include "record/statistics/statistics.hpp"
#include "record/thoughts_file.hpp"
#include "web/page_parts.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace mirocup::web {

// Whether the page shows times that a clock measured. Such times differ in each run of a leg; a
// page without them has equal bytes on every machine.
enum class Times { shown, left_out };

// Simulates the leg again to get the positions, and returns the data that page/main.js reads: the
// schema "mirocup/page/1". The error names the first tick in which the record is not reproduced.
tl::expected<record::Json, replay::Divergence> replay_data(const record::MatchRecord& record,
                                                           Times times = Times::shown);

// Returns the data in a page that replay_page() has made, also in another version; nothing if
// the text `html` has no such data.
std::optional<record::Json> data_of_page(std::string_view html);

// Returns the first moment of the leg as an SVG element, whose bodies page/field.js moves.
std::string first_picture(const record::MatchRecord& record);

// The data with which a visitor's browser can simulate the leg again: the module of this program,
// and the commands of both teams.
struct Proof {
  std::optional<BrowserModule> module = {};  // the module, if it is in the page and not in a file
  // Link from the page to module_file(); "": the module is not a file.
  std::string module_file = "";
  // Link from the page to commands_script(); "": the page has the commands.
  std::string commands_file = "";
};

// Whether a page shows the data that only the teams may see: for each robot the commanded and the
// real wheel speeds, and the age of the picture in which the team saw the robot.
enum class Wheels { shown, left_out };

struct ReplayPage {
  std::string html;
  statistics::LegStatistics statistics;  // the statistics on the page
  std::size_t proof_size = 0;            // number of bytes in the page for the proof of the leg
};

// Returns script and style of replay pages as files for all pages of a site, NAME.js and NAME.css.
// NAME has a hash of their content.
std::vector<ScriptFile> page_files();

// Returns the page of the leg, with its data. `links` is HTML for the top of the page, such as
// links to the other pages of a league. `own` has thoughts and logs of the teams; leave it out for
// a public page. Visitors can prove the leg only if `proof` has or names a module. `files` is the
// link from the page to the folder of page_files(); without it the page has script and style
// inside.
tl::expected<ReplayPage, replay::Divergence> replay_page(
    const record::MatchRecord& record, Times times = Times::shown, const record::OwnTexts& own = {},
    const std::optional<Proof>& proof = {}, Wheels wheels = Wheels::left_out,
    const std::string& links = "", const std::optional<std::string>& files = {});

// Returns the script file with the commands of both teams for a page of this record.
std::string commands_script(const record::MatchRecord& record);

// Returns the page of a running match, which gets the match from the events at "events" beside it.
// `about` is a line for the foot of the page.
std::string live_page(const match::Leg& match, const match::ByTeam<std::string>& names,
                      const std::string& about);

}  // namespace mirocup::web
