// SPDX-License-Identifier: MIT
//
// The common state of the parts of the portal: the book of a league, and the host's options.
#pragma once

#include "tournaments/handin/entry_report.hpp"
#include "tournaments/handin/own_legs.hpp"
#include "tournaments/handin/team_desk_page.hpp"
#include "tournaments/league/submission.hpp"

#include <atomic>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace mirocup::league {

struct FriendlyOptions {
  // Returns the teams of the league against which a friendly can be played, with the entries with
  // which they play by the journal; 0: none yet.
  std::function<std::map<std::string, int>()> teams;
  // Returns the neighbours of a team in the table; no teams before the league has a table.
  std::function<std::vector<std::string>(const std::string& team)> neighbours;
  // The house teams, without "house:".
  std::vector<std::string> house;
  bool has_drills = false;  // true: entries try drills; the league has the field of the drills
  // Returns the page that replays the record at a path, with the thoughts and logs of the given
  // teams. `root` is web::root_of() the address of the page.
  std::function<std::optional<std::string>(const std::string& record, const record::Whose& whose,
                                           const std::string& root)>
      replay;
};

struct PortalOptions {
  Quota quota = {};
  std::string team_header = {};  // header in which a trusted proxy names the team: see Doorkeeper
  int max_waiting = 4;           // the most hand-ins of one team without an answer
  int max_uploads = 2;           // the most files that one team may send at once

  // Calls hand_in_terms() for the league; `now` is UTC.
  std::function<HandInTerms(const std::string& team, const std::string& now)> terms;
  // Returns the decided legs of a team that a viewer, the team or the staff, may see.
  std::function<std::vector<OwnLeg>(Viewer viewer, const std::string& team)> legs;
  // Returns the team's digest of the last night as part of a page; "" if the team may not see its
  // digest.
  std::function<std::string(const std::string& team)> digest = {};
  // Returns the replay page of a leg, by the name of its record. The page has the kept thoughts and
  // logs of the teams in `whose`, and HTML with links. Returns nothing if the leg has no page.
  std::function<std::optional<std::string>(const std::string& name, const record::Whose& whose,
                                           const std::string& links)>
      replay = {};
  // Returns sheets_of_team().
  std::function<Json(const std::string& team)> sheets = {};
  // Returns the name by which people know a team.
  std::function<std::string(const std::string& team)> shown_name = [](const std::string& team) {
    return team;
  };
  TimeInWords time_in_words = [](const std::string& utc) { return utc; };
  FriendlyOptions friendlies;
  std::function<std::int64_t()> now;  // s since 1970
  // Called when this program has written to the league, before anybody gets the answer: what the
  // other functions return must show it.
  std::function<void()> has_written = [] {};
};

struct DeskState {
  DeskState(system::Files& disk, Folder place, PortalOptions given, Book kept)
      : files(disk),
        folder(std::move(place)),
        options(std::move(given)),
        costs(files, folder),
        book(std::move(kept)) {}

  HandInTerms terms_of(const std::string& team) const {
    return options.terms(team, utc_text(options.now()));
  }

  system::Files& files;
  const Folder folder;
  const PortalOptions options;
  LegCosts costs;
  std::atomic<std::uint64_t> version{1};  // grows with each change that a team may see

  std::mutex mutex;  // guards the members below
  Book book;
  std::map<std::pair<std::string, int>, CheckStep> steps;  // of the running checks
};

}  // namespace mirocup::league
