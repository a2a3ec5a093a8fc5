// SPDX-License-Identifier: MIT
//
// teams.json: by what names people know the teams of a league, and who is in them. It decides
// nothing, may change at any time, and is closed to other users. In an anonymous league only the
// staff reads the names; pages have those of league.json, the aliases.
#pragma once

#include "tournaments/league/folder.hpp"

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace mirocup::league {

struct People {
  std::string display;               // any letters: "Zoë & Co"; "": the team's name
  std::vector<std::string> members;  // names or matriculation numbers
  std::string colour = {};           // of the mark beside its name, "#c03a2b"; "": it has no mark
  std::vector<std::pair<std::string, std::string>> more = {};  // further columns of the class list

  bool operator==(const People&) const = default;
};
using PeopleOfTeams = std::map<std::string, People>;  // by the team's name

// Returns why a text is no name for people; "" if it is one: UTF-8 that can be printed in a line,
// at most 60 bytes.
std::string objection_to_display(const std::string& text);

// Returns why a person may not name a team or a member so now, although names from before stay:
// as above, or a character that nobody sees. "": the name may be taken.
std::string objection_to_new_name(const std::string& text);

// Returns why these are no names that a person may give now; "": they are.
std::string objection_to(const People& one);

// Returns the other team that people would take for this one if it had that display name: by its
// own name or its display name, whatever capitals and blanks it is written with. It may be a team
// of the league or of the names here. "": there is none.
std::string looks_like(const PeopleOfTeams& people, const LeagueState& state,
                       const std::string& team, const std::string& display);

// Returns the members that a person wrote with semicolons or line ends between them.
std::vector<std::string> members_of(const std::string& text);

// Returns why a text is no colour; "" if it is one: '#' and six hexadecimal digits.
std::string objection_to_colour(const std::string& text);

// Sets the colour; "" takes the mark away. Errors: Errc::input.
Result<void> set_colour(People& one, const std::string& colour);

// Reads and writes the file; a league without it has no such names. Errors: Errc::input.
Result<PeopleOfTeams> read_people(system::Files& files, const Folder& folder);
Result<void> write_people(system::Files& files, const Folder& folder, const PeopleOfTeams& people);

// Returns the colours that pages show, by the team's name in the league.
std::map<std::string, std::string> shown_colours(const LeagueFile& file,
                                                 const PeopleOfTeams& people);

// Returns the names that pages show, in the order of the teams; empty if they are the teams' own.
std::vector<std::string> shown_names(const LeagueFile& file, const PeopleOfTeams& people);

}  // namespace mirocup::league
