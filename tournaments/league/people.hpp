// SPDX-License-Identifier: MIT
//
// teams.json: the display names of a league's teams, and their members. The file has no effect on
// results, may change at any time, and is closed to other users. In an anonymous league only the
// staff reads the names of teams.json; pages show the aliases in league.json.
#pragma once

#include "tournaments/league/folder.hpp"

#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace mirocup::league {

struct People {
  std::string display;               // any letters: "Zoë & Co"; "": the team's name
  std::vector<std::string> members;  // names or matriculation numbers
  std::vector<std::pair<std::string, std::string>> more = {};  // further columns of the class list

  bool operator==(const People&) const = default;
};
using PeopleOfTeams = std::map<std::string, People>;  // by the team's name

// Returns the first reason why a person may not give these names; "" if the person may give all. A
// name is UTF-8 that can be printed in a line, at most 60 bytes, and new names have no invisible
// character.
std::string objection_to(const People& one);

// Returns another team, of the league or of `people`, that readers could confuse with `team` if
// `team` had the display name `display`; "" if none is so similar. Names and display names are
// compared without capitals, blanks and differences of how Unicode writes the same letter
// (NFKC_Casefold).
std::string looks_like(const PeopleOfTeams& people, const LeagueState& state,
                       const std::string& team, const std::string& display);

// Returns the members that a text lists, separated by semicolons or line ends.
std::vector<std::string> members_of(const std::string& text);

// Returns what a cell says of each member, between semicolons; some may be "". There is at least
// one.
std::vector<std::string> parts_of(const std::string& cell);

// Reads and writes teams.json; a league without teams.json has no display names. Errors:
// Errc::input.
Result<PeopleOfTeams> read_people(system::Files& files, const Folder& folder);
Result<void> write_people(system::Files& files, const Folder& folder, const PeopleOfTeams& people);

// Changes what is known of a team of the league or of the class list, and returns it. Errors:
// Errc::input if nobody may have these names.
Result<People> change_people(system::Files& files, const Folder& folder, const LeagueState& state,
                             const std::string& team, const std::function<void(People&)>& change);

// Returns the names that pages show, in the order of the teams; empty if pages show the teams' own
// names.
std::vector<std::string> shown_names(const LeagueFile& file, const PeopleOfTeams& people);

}  // namespace mirocup::league
