// SPDX-License-Identifier: MIT
//
// A replay page for every leg that was played. `mirocup replay` makes the pages, several at once.
// It leaves out measured times, so that a page depends on its record only. Beside each page
// `mirocup replay` writes the statistics of the leg (league_statistics.hpp), so a leg is simulated
// again only once, and a record that differs from its replay gets no page. An existing page stays
// unless its record, or what the league puts on the page, was changed after it.
#pragma once

#include "tournaments/league/folder.hpp"
#include "tournaments/publish/leg_view.hpp"

#include <algorithm>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace mirocup::league {

// The module with which browsers prove legs, as a script file of the site.
struct SiteModule {
  std::string name;  // "module/HASH.js"
  std::string text;
};

// Returns the path of a record's page inside site/: "replays/x.html" for "records/x.json".
std::string replay_page_of(const std::string& record);

// Returns the path inside site/ of the script file with the commands of a record's leg. The file
// "replays/x.proof.js" exists only if the page "replays/x.html" has a proof.
std::string commands_file_of(const std::string& record);

// Returns the fixture of a record, also of a void attempt: "r1-f2" for "records/r1-f2-1-1.json".
const FixtureState* fixture_of_record(const LeagueState& state, const std::string& record);

// Returns the path of a record's page after `root`; "" if the page was removed to save room.
std::string page_of_record(const LeagueState& state, const std::string& root,
                           const std::string& record);

// The pages that could not be made. The league is published without them.
struct FailedPages {
  std::vector<std::string> records;  // without a page: paths inside the league
  std::set<std::string> refused;     // the records of the legs that were taken out

  bool has(const std::string& record) const {
    return std::find(records.begin(), records.end(), record) != records.end();
  }
};

// Makes the missing pages, `jobs` at once (0: one for each processor), and removes pages of pruned
// nights and of legs that the state lacks. The statistics of pruned nights stay. A page gets a
// proof by `module`, if there is one. Takes each leg whose record differs from its replay out of
// the state; if a person decided the leg, only the record.
Result<FailedPages> make_replay_pages(system::Files& files, const Folder& folder,
                                      LeagueState& state, int jobs,
                                      const std::optional<SiteModule>& module = {});

// Returns what the league puts on the replay page of a record: {"links": HTML with links to the
// front page, the round, both teams and the legs before and after, and with a note if the leg does
// not count; "names": the display names of blue and yellow, or [] if the record is of no fixture}.
// `record` is the path inside the league folder.
Json league_part(const Overview& overview, const std::string& record);

// True if site/ has the record's page with this part.
bool has_page_with(system::Files& files, const Folder& folder, const std::string& record,
                   const Json& part);

}  // namespace mirocup::league
