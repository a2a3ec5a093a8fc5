// SPDX-License-Identifier: MIT
//
// The desk of a league in the network: who hands in, what of, and what became of it. It answers the
// requests of the HTTP API and of the private pages, and gives the queue's next check to
// CheckRunner. docs/handing-in.md describes the API.
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
  ProxyTrust proxy = {};
  int max_waiting = 4;  // hand-ins of one team without an answer
  int max_uploads = 2;  // of one team at once

  // Returns why no entry of a team is taken at a time, a sentence; "" if entries are taken.
  std::function<std::string(const std::string& team, const std::string& now)> why_not;
  // Returns the decided legs of a team.
  std::function<std::vector<OwnLeg>(const std::string& team)> legs;
  // Returns what the last night changed for a team, as the inside of a page; "" if it may not know.
  std::function<std::string(const std::string& team)> digest = {};
  // Returns the replay page of a leg, by the name of its record, with what was kept of the thoughts
  // and logs of these teams; nothing if there is no page.
  std::function<std::optional<std::string>(const std::string& name, const record::Whose& whose)>
      replay = {};
  // Returns the part of a page with the football statistics of a team, HTML; "" if there are none.
  std::function<std::string(const std::string& team)> statistics;
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

  // Marks the next hand-in as being checked and returns it; nothing if none is to be checked.
  std::optional<WaitingHandIn> begin_next();
  bool has_next();

  void set_step(const std::string& team, int entry, const CheckStep& step);

  // Books what became of a check.
  Result<void> close(const std::string& team, int entry, HandInState state,
                     const std::string& message);

  // A check has ended without an answer, and is tried again. After some failures of the host the
  // hand-in is void. If it has used up its processor time, `seconds`, that is the file's own fault,
  // but one time it may have had bad luck: the second time the hand-in is refused.
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
