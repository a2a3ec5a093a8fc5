// SPDX-License-Identifier: MIT
//
// A replay page for every leg that was played. `mirocup replay` makes the pages, several at once.
// It leaves out measured times, so that a page depends on its record only. Beside each page
// `mirocup replay` writes the statistics of the leg, so a leg is simulated again only once, and a
// record that differs from its replay gets no page. An existing page stays unless its record, or
// what the league puts on the page, was changed after it.
#pragma once

#include "tournaments/league/folder.hpp"
#include "tournaments/publish/leg_view.hpp"
#include "tournaments/publish/site_file.hpp"

#include <optional>
#include <set>
#include <string>
#include <vector>

namespace mirocup::league {

// What is known of the legs once their pages are made.
struct PublishedLegs {
  KnownLegs known;
  // Records whose page could not be made, paths inside the league. The league is published without
  // these pages.
  std::vector<std::string> without_page;
  std::set<std::string> refused;  // the records of the legs that were taken out
};

// The files beside replay pages, which all pages of a program share.
struct PageParts {
  std::vector<SiteFile> page;           // their script and style
  std::optional<SiteFile> module = {};  // with which browsers prove legs; nothing: without proofs

  std::vector<SiteFile> all() const;
};

// Makes the missing pages, `jobs` at once (0: one for each processor), and removes pages of pruned
// nights and of legs that the state lacks. The statistics of pruned nights stay. Takes each leg
// whose record differs from its replay out of the state; if a person decided the leg, only the
// record.
Result<PublishedLegs> publish_legs(system::Files& files, const Folder& folder, LeagueState& state,
                                   const PageParts& parts, int jobs);

// Returns what the league puts on the replay page of a record: {"links": HTML with links to the
// front page, the round, both teams and the legs before and after, and with a note if the leg does
// not count; "names": the display names of blue and yellow, or [] if the record is of no fixture}.
// `record` is the path inside the league folder.
Json league_part(const Overview& overview, const std::string& record);

// True if site/ has the record's page with this part.
bool has_page_with(system::Files& files, const Folder& folder, const std::string& record,
                   const Json& part);

}  // namespace mirocup::league
