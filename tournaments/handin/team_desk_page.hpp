// SPDX-License-Identifier: MIT
//
// The pages of the desk, and the page around their content: the page that asks for a token, and the
// private page of a team, where the team hands in and reads the answers to its entries.
// web/page/hand_in.js sends the forms and follows checks.
#pragma once

#include "record/json_reader.hpp"
#include "tournaments/handin/portal_league.hpp"

#include <string>
#include <vector>

namespace mirocup::league {

using Json = nlohmann::ordered_json;
using record::text_in;

// The content of a team's private page.
struct TeamDesk {
  PortalLeague& league;
  std::string team;
  Json entries = {};                        // entry_report() of entries, the latest first
  Json older = {};                          // Entries::reports()
  Json legs = {};                           // own_legs_json()
  Json friendlies = {};                     // FriendlyDesk::list()
  Json progress = {};                       // progress_of()
  std::vector<std::string> opponents = {};  // possible opponents in friendlies
  int playing = 0;                          // the entry that plays; 0: none yet
  bool is_pinned = false;                   // that entry plays even if a later one is accepted
  Json mark = {};                           // Folder::released_mark(); null: none
  Json sheets = {};                         // sheets_of_team(); empty: none
  std::string deadline = {};  // until when the team may hand in, UTC; "": no such time
  bool is_late = false;       // that time is past
  std::string digest = {};    // HTML: the digest of the last night; "": none
};

// Returns a page with this content, in the design of all pages. `root` is the way from the page's
// address to the top of the site: web::root_of(). It is "" at /hand-in.
std::string desk_page(const std::string& title, const std::string& content,
                      const std::string& root = "");

// Returns the number at a key of an object in a printf format; "" if the object has no such number.
std::string number_text(const Json& object, const char* key, const char* format);

// `why` is a sentence about the fault of the last token; "" for the first try.
std::string log_in_page(const std::string& why, const std::string& root);

std::string team_desk_page(const TeamDesk& desk);

// The page of one entry: its answer and the results of `mirocup check`, from entry_report(). The
// links of the staff name the team.
std::string entry_page(const Json& entry, PortalLeague& league, const std::string& root,
                       bool is_for_staff);

}  // namespace mirocup::league
