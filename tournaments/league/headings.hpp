// SPDX-License-Identifier: MIT
//
// Headings of a class list's columns: those that Moodle, Artemis and people write, in English and
// German, or those that a person names. A field is what a column says: "team", "display",
// "members", "first", "last" (parts of a student's name), "mail" or "number".
#pragma once

#include "tournaments/league/people.hpp"

#include <string>
#include <vector>

namespace mirocup::league {

// Gives each known column the name of its field, but columns of mails and numbers only if `words`
// of a person name them, as in "team=Gruppe,mail=Kontakt". Headings are compared without capitals,
// digits and signs. Errors: Errc::input.
Result<void> name_fields(std::vector<std::string>& headings, const std::string& words);

// Returns the heading, of these, of the column with this field; "": there is none.
std::string heading_of(const std::string& field, const std::vector<std::string>& headings);

// Returns what the further columns say of a team in this field; "": nothing.
std::string said_of(const People& one, const std::string& field);

}  // namespace mirocup::league
