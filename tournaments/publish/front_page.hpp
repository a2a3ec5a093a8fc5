// SPDX-License-Identifier: MIT
//
// The front page of a league, and the pages of its rounds, of its crosstable and of its teams.
#pragma once

#include "tournaments/publish/league_statistics.hpp"
#include "tournaments/publish/rounds.hpp"
#include "tournaments/publish/strength_history.hpp"

#include <string>
#include <vector>

namespace mirocup::league {

// The data that all pages of a site share.
struct SiteContent {
  const Overview& overview;
  const LegReports& reports;
  std::vector<RoundView> rounds;
  StrengthHistory history;
  bool has_night = false;  // true: the site has night.html
  bool has_playground = false;
  std::string closing_page = {};  // as SiteSource::closing_page
};

// Returns the first three teams and the certainty of the first place as values of a template; false
// before the league is over.
Json champion_values(const Overview& overview);

// Returns the decisions of people as values of a template, each with the keys number, at, by, what,
// why and undoing.
Json decisions_values(const LeagueState& state);

std::string front_html(const SiteContent& content);

// Returns the page of a round. `round` is an index of SiteContent::rounds.
std::string round_html(const SiteContent& content, std::size_t round);

// crosstable_html() returns the page of the crosstable. Precondition: has_crosstable(), which is
// false for too many teams.
bool has_crosstable(const SiteContent& content);
std::string crosstable_html(const SiteContent& content);

// Returns the page of a team: its rank, form, strength, best and worst legs, faults and all legs.
// `team` is its index in the league.
std::string team_html(const SiteContent& content, int team);

}  // namespace mirocup::league
