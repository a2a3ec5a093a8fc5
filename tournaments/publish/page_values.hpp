// SPDX-License-Identifier: MIT
//
// The values that several pages of a league give to their templates (page/*.html).
#pragma once

#include "tournaments/publish/rounds.hpp"

#include <string>
#include <string_view>

namespace mirocup::league {

// Returns the text of page/NAME; empty if there is no such file.
std::string_view page_file(std::string_view name);

// Returns the template page/NAME filled with values.
std::string filled_page(std::string_view name, const Json& values);

// Returns the values of head.html and top.html. `root` leads from the page to the top of the site:
// "" or "../". `title` is the title of the page; "" for the front page, whose title is the league's
// name.
Json page_values(const Overview& overview, const std::string& root, const std::string& title);

// Returns the mark of a team's colour, as markup for the place before its name; "" if it has none.
std::string mark_of(const LeagueState& state, int team);

// {name, mark, page, index} of a team.
Json team_values(const Overview& overview, int team, const std::string& root);

// Returns the values of fixture.html: {id, home, away, legs [{score, page, record}], open [],
// notes}. The home team's goals come first.
Json fixture_values(const Overview& overview, const FixtureView& fixture, const std::string& root);
Json fixtures_values(const Overview& overview, const RoundView& round, const std::string& root);

// The score of a leg as a team sees it, with that of a shoot-out: "1:1 (3:2 p)".
std::string score_text(const LegView& leg, int team);

// Returns the values of a line of leg.html, a leg with a link: {score, page, home, away, where,
// why}.
Json leg_values(const Overview& overview, const LegView& leg, const std::string& root,
                const std::string& why);

// The last results of a team: [{letter, word, page}], the latest last.
Json form_values(const Overview& overview, int team, std::size_t most, const std::string& root);

// A strength on a scale that all teams share: {value, low, high, picture}.
Json strength_values(const Overview& overview, int team);

// The names of all teams in the order of the alphabet, for the filter: [{name, index}].
Json filter_values(const Overview& overview);

}  // namespace mirocup::league
