// SPDX-License-Identifier: MIT
//
// Accepts friendlies, gives them to the runner, and shows result and replay to the two teams that
// play. Only a team itself sees its thoughts and the log of its process. A leg of a burst is shown
// only to the team whose burst it is.
//
// Threads: all public functions may be called by any thread at any time.
#pragma once

#include "tournaments/handin/book.hpp"
#include "tournaments/handin/own_legs.hpp"
#include "web/http/request.hpp"

#include <functional>
#include <memory>
#include <mutex>
#include <set>

namespace mirocup::league {

struct FriendlyOptions {
  // Returns the teams of the league against which a friendly can be played, with their entries.
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

class FriendlyDesk {
 public:
  static Result<std::unique_ptr<FriendlyDesk>> open(system::Files& files, const Folder& folder,
                                                    FriendlyOptions options, std::string* notice);

  // To be called when an entry was accepted: adds its burst, and makes waiting legs of older
  // entries void. Does nothing if the entry already had its burst.
  Result<void> entry_accepted(const std::string& team, int entry, std::int64_t now);

  // POST: a team asks for a leg.
  web::Reply ask(const std::string& team, const std::string& opponent, std::int64_t now);

  // Returns the legs of a team, the latest first, and its possible opponents.
  Json list(const std::string& team, LegCosts& costs);
  std::vector<std::string> opponents(const std::string& team);

  // Returns the marks of an entry in drills, {"score", "drills": [{"name", "version", "score"}]};
  // null if the marks are not known.
  Json drills_of(const std::string& team, int entry) const;

  // GET below the path of friendlies, "/TEAM/NUMBER/log" or "/TEAM/NUMBER/replay".
  // `root` is web::root_of() the whole path.
  web::Reply show(const std::string& visitor, std::string_view rest, const std::string& root);

  // For the runner. When no leg waits, begin_next() returns the drills of an entry. A leg is void
  // after the host has failed in it several times. A leg that was stopped for a check waits again.
  std::optional<Friendly> begin_next();
  Result<void> played(const Friendly& friendly, std::int64_t now);
  Result<void> failed(const Friendly& friendly, std::int64_t now, bool is_spoiled = true);

 private:
  FriendlyDesk(system::Files& files, Folder folder, FriendlyOptions options, FriendlyBook book)
      : files_(files),
        folder_(std::move(folder)),
        options_(std::move(options)),
        book_(std::move(book)) {}

  Json json_of(const Friendly& friendly, const std::string& viewer, LegCosts& costs);
  void forget_old_records(const std::string& team);
  std::optional<Friendly> next_drills();

  system::Files& files_;
  const Folder folder_;
  const FriendlyOptions options_;
  std::mutex mutex_;  // guards the members below
  FriendlyBook book_;
  // Entries whose drills this server has begun, or whose marks are known.
  std::set<std::pair<std::string, int>> drills_begun_;
};

}  // namespace mirocup::league
