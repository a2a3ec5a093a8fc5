// SPDX-License-Identifier: MIT
//
// The values that several pages of a league give to their templates (page/*.html).
#pragma once

#include "tournaments/publish/rounds.hpp"

#include <string>
#include <string_view>

namespace mirocup::league {

// Returns the text of the file page/NAME; empty if the program lacks the file.
std::string_view page_file(std::string_view name);

// Returns the template page/NAME filled with values.
std::string filled_page(std::string_view name, const Json& values);

// Returns the values of head.html and top.html. `root` leads from the page to the top of the site:
// "" or "../". `title` is the title of the page; "" for the front page, which has the league's name
// as its title.
Json page_values(const Overview& overview, const std::string& root, const std::string& title);

// Returns the values of a team: {name, page, index}.
Json team_values(const Overview& overview, int team, const std::string& root);

// Returns the values of fixture.html: {id, home, away, legs [{score, page, record}], open [],
// notes}. The home team's goals come first.
Json fixture_values(const Overview& overview, const FixtureView& fixture, const std::string& root);
Json fixtures_values(const Overview& overview, const RoundView& round, const std::string& root);

// Returns the score of a leg with a team's own goals first, and the score of a shoot-out: "1:1 (3:2
// p)".
std::string score_text(const LegView& leg, int team);

// Returns the values of a line of leg.html, a leg with a link: {score, page, home, away, where,
// why}.
Json leg_values(const Overview& overview, const LegView& leg, const std::string& root,
                const std::string& why);

// Returns the last results of a team, [{letter, word, page}], the latest last.
Json form_values(const Overview& overview, int team, std::size_t most, const std::string& root);

// Returns a team's strength, {value, low, high, picture}, on a common scale of all teams.
Json strength_values(const Overview& overview, int team);

// Returns the names of all teams in alphabetical order for the page's filter: [{name, index}].
Json filter_values(const Overview& overview);

}  // namespace mirocup::league
