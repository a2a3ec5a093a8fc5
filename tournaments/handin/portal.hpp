// SPDX-License-Identifier: MIT
//
// The HTTP front of a league: accepts hand-ins and reports their state. It answers the requests of
// the HTTP API and of the private pages, and gives the queue's next check to CheckRunner.
// docs/handing-in.md describes the API.
//
// Threads: all public functions may be called by any thread at any time.
#pragma once

#include "tournaments/handin/book.hpp"
#include "tournaments/handin/doorkeeper.hpp"
#include "tournaments/handin/entry_report.hpp"
#include "tournaments/handin/friendly_desk.hpp"
#include "tournaments/handin/own_legs.hpp"
#include "tournaments/handin/staff_desk.hpp"
#include "tournaments/handin/team_desk_page.hpp"
#include "tournaments/league/hand_ins.hpp"

#include <atomic>
#include <functional>
#include <mutex>

namespace mirocup::league {

struct PortalOptions {
  Quota quota = {};
  std::string team_header = {};  // of a trusted proxy: see Doorkeeper
  int max_waiting = 4;           // hand-ins of one team without an answer
  int max_uploads = 2;           // of one team at once

  // Returns a sentence that says why no entry of a team is taken at that time; "" if entries are
  // taken.
  std::function<std::string(const std::string& team, const std::string& now)> why_not;
  // Returns the decided legs of a team.
  std::function<std::vector<OwnLeg>(const std::string& team)> legs;
  // Returns the team's digest of the last night as part of a page; "" if the team may not see it.
  std::function<std::string(const std::string& team)> digest = {};
  // Returns the replay page of a leg, by the name of its record. The page has the kept thoughts and
  // logs of the teams in `whose`. Returns nothing if the leg has no page.
  std::function<std::optional<std::string>(const std::string& name, const record::Whose& whose)>
      replay = {};
  // Returns the part of a page with the football statistics of a team, HTML; "" if there are none.
  std::function<std::string(const std::string& team)> statistics;
  // Returns the name by which people know a team.
  std::function<std::string(const std::string& team)> shown_name = [](const std::string& team) {
    return team;
  };
  TimeInWords time_in_words = [](const std::string& utc) { return utc; };
  FriendlyOptions friendlies;
  std::function<std::int64_t()> now;  // s since 1970
};

class Portal {
 public:
  static Result<std::unique_ptr<Portal>> open(system::Files& files, const Folder& folder,
                                              PortalOptions options, std::string* notice);

  // The function web::Site::desk.
  std::optional<web::Reply> answer(const web::Request& request, const web::Body& body);

  // The friendlies, for their runner.
  FriendlyDesk& friendlies() { return *friendlies_; }

  // Marks the next hand-in as being checked and returns it; nothing if no check may begin.
  std::optional<WaitingHandIn> begin_next();
  bool has_next();

  void set_step(const std::string& team, int entry, const CheckStep& step);

  // Books the answer of a check.
  Result<void> close(const std::string& team, int entry, HandInState state,
                     const std::string& message);

  // To be called when a check has ended without an answer: the check is tried again. After some
  // failures of the host the hand-in is void. A check that has used up its processor time,
  // `seconds`, is tried once more; the second time the hand-in is refused.
  Result<void> wait_again(const std::string& team, int entry, NoAnswer why = NoAnswer::host_failed,
                          double seconds = 0.0);

  // HandInQueue::to_stop().
  std::optional<WaitingHandIn> to_stop(const std::vector<RunningCheck>& running);

 private:
  struct Upload;

  Portal(system::Files& files, Folder folder, PortalOptions options, HandInBook book,
         std::unique_ptr<FriendlyDesk> friendlies);
  Result<void> finish_what_was_begun();

  std::variant<Visitor, web::Reply> visitor(const web::Request& request, Purpose purpose);
  web::Reply api(const web::Request& request, const web::Body& body);
  web::Reply log_in(const web::Request& request, const web::Body& body);
  web::Reply log_out(const web::Request& request);
  web::Reply staff(const web::Request& request, const web::Body& body);
  web::Reply own_replay(const web::Request& request);
  web::Reply take(const web::Request& request, const web::Body& body, const Visitor& visitor);
  web::Reply keep(const Visitor& visitor, const std::string& name, system::IncomingFile& file,
                  const std::string& sha256);
  web::Reply pin(const web::Request& request, const Visitor& visitor);
  web::Reply friendly_reply(const web::Request& request, const Visitor& visitor);
  web::Reply entry_reply(const std::string& team, std::string_view rest);
  web::Reply team_page(const std::string& team);
  web::Reply leg_reply(const std::string& team, std::string_view rest);
  web::Reply events(const std::string& team, int entry);
  std::optional<web::Reply> refused_now(const std::string& team);
  Result<Json> report(const std::string& team, int entry, bool is_whole);
  Result<Json> reports(const std::string& team);
  Json about(const Visitor& visitor);

  system::Files& files_;
  const Folder folder_;
  const PortalOptions options_;
  LegCosts costs_;
  const StaffDesk staff_;
  const std::unique_ptr<FriendlyDesk> friendlies_;
  std::atomic<std::uint64_t> version_{1};  // grows with each change that a team may see

  std::mutex mutex_;  // guards what follows
  HandInBook book_;
  Doorkeeper doorkeeper_;
  std::map<std::pair<std::string, int>, CheckStep> steps_;  // of the running checks
  std::map<std::string, int> uploads_;                      // running, of each team
};

}  // namespace mirocup::league
