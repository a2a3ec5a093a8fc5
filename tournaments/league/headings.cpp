// SPDX-License-Identifier: MIT
#include "tournaments/league/headings.hpp"

#include "system/text.hpp"

#include <algorithm>
#include <array>
#include <string_view>

namespace mirocup::league {

namespace {

// Headings in plain letters between blanks; of two, the first one counts. A line begins with the
// name of its field.
constexpr std::array<std::string_view, 7> known{
    " team teamname group groups groupname gruppe gruppen gruppenname projectgroup projektgruppe "
    "mannschaft ",
    " display displayname anzeigename ",
    " members member mitglieder mitglied fullname studentname student students "
    "vollstndigername vollstaendigername teilnehmer teilnehmerin studierende nachnamevorname "
    "lastnamefirstname surnamefirstname namevorname vornamenachname firstnamelastname name ",
    " first firstname forename givenname vorname vornamen rufname ",
    " last lastname surname familyname nachname familienname zuname ",
    " mail email emailaddress mailaddress emailadresse mailadresse emails ",
    " number idnumber idnummer sid studentid studentnumber matriculation matriculationnumber "
    "registrationnumber matrikel matrikelnummer matrikelnr matrnr id ",
};

}  // namespace

Result<void> name_fields(std::vector<std::string>& headings, const std::string& words) {
  for (const std::string& pair : parts_of(system::replaced(words, ",", ";"))) {
    if (words.empty()) break;
    const std::string field = system::lower_case(pair.substr(0, pair.find('=')));
    const auto named = std::ranges::find_if(headings, [&](const auto& one) {
      return system::lower_case(pair) == field + '=' + system::lower_case(one);
    });
    if (named == headings.end() || heading_of(field, {field}).empty()) {
      return fail(Errc::input, "--columns " + pair +
                                   ": KEY=HEADING is expected; a key is team, display, members, "
                                   "first, last, mail or number, a heading " +
                                   system::joined(headings, " or "));
    }
    *named = field;
  }
  for (const std::string field : {"team", "display", "members", "first", "last"}) {
    const std::string heading = heading_of(field, headings);
    if (!heading.empty()) std::ranges::replace(headings, heading, field);
  }
  return {};
}

std::string heading_of(const std::string& field, const std::vector<std::string>& headings) {
  const auto line = std::ranges::find_if(
      known, [&](std::string_view one) { return one.starts_with(' ' + field + ' '); });
  std::string best;
  for (std::size_t place = std::string_view::npos; const std::string& heading : headings) {
    std::string word = system::lower_case(heading);
    std::erase_if(word, [](char c) { return c < 'a' || c > 'z'; });
    const std::size_t here = line == known.end() ? place : line->find(' ' + word + ' ');
    if (word.empty() || here >= place) continue;
    best = heading;
    place = here;
  }
  return best;
}

std::string said_of(const People& one, const std::string& field) {
  std::vector<std::string> headings;
  for (const auto& [heading, value] : one.more) headings.push_back(heading);
  for (const auto& [heading, value] : one.more)
    if (heading == heading_of(field, headings)) return value;
  return "";
}

}  // namespace mirocup::league
