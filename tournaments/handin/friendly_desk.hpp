// SPDX-License-Identifier: MIT
//
// Accepts friendlies, gives them to the runner, and shows result and replay to the two teams that
// play. Only a team itself sees its thoughts and the log of its process. A leg of a burst is shown
// only to the team whose burst it is.
//
// Threads: all public functions may be called by any thread at any time.
#pragma once

#include "tournaments/handin/desk_state.hpp"
#include "web/http/request.hpp"

#include <set>

namespace mirocup::league {

class FriendlyDesk {
 public:
  explicit FriendlyDesk(DeskState& state) : state_(state) {}

  // To be called when an entry was accepted: writes its burst. Does nothing if the entry or a later
  // one had its burst, or if there is no entry, 0. Requires the mutex of the state.
  Result<void> entry_accepted(const std::string& team, int entry);

  // POST: a team asks for a leg.
  web::Reply ask(const std::string& team, const std::string& opponent);

  // Returns the legs of a team, the latest first, and its possible opponents.
  Json list(const std::string& team, LegCosts& costs);
  std::vector<std::string> opponents(const std::string& team);

  // Returns the marks of an entry in drills, {"score", "drills": [{"name", "version", "score"}]};
  // null if the marks are not known.
  Json drills_of(const std::string& team, int entry) const;

  // Shows the log or the replay of a leg; `what` is "log" or "replay". `root` is web::root_of() the
  // path of the request.
  web::Reply show(const std::string& visitor, const std::string& team, std::string_view number,
                  std::string_view what, const std::string& root);

  // For the runner. When no leg waits, begin_next() returns the drills of an entry. A leg is void
  // after the host has failed in it several times. A leg that was stopped for a check waits again.
  std::optional<Friendly> begin_next();
  Result<void> played(const Friendly& friendly);
  Result<void> failed(const Friendly& friendly, bool is_spoiled = true);

 private:
  Json json_of(const Friendly& friendly, const std::string& viewer, LegCosts& costs) const;
  void forget_old_records(const std::string& team);
  std::optional<Friendly> next_drills();
  std::map<std::string, int> entries_that_play();

  DeskState& state_;
  // Entries whose drills this server has begun, or whose marks are known. Guarded by the mutex of
  // the state.
  std::set<std::pair<std::string, int>> drills_begun_;
};

}  // namespace mirocup::league
