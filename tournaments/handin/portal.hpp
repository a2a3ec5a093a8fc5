// SPDX-License-Identifier: MIT
//
// The HTTP front of a league: accepts hand-ins and reports their state. It answers the requests of
// the HTTP API and of the private pages, and gives the queue's next check to CheckRunner.
// docs/handing-in.md describes the API.
//
// Threads: all public functions may be called by any thread at any time.
#pragma once

#include "system/file_lock.hpp"
#include "tournaments/handin/doorkeeper.hpp"
#include "tournaments/handin/entries.hpp"
#include "tournaments/handin/friendly_desk.hpp"
#include "tournaments/handin/routes.hpp"
#include "tournaments/handin/staff_desk.hpp"
#include "tournaments/handin/uploads.hpp"

#include <span>

namespace mirocup::league {

class Portal {
 public:
  // `files` and `league` must outlive the portal.
  static Result<std::unique_ptr<Portal>> open(system::Files& files, const Folder& folder,
                                              PortalLeague& league, PortalOptions options,
                                              std::string* notice);

  // A route: a pattern of paths (see match_path), the people who may use the route, and its
  // handler.
  struct Route {
    std::string_view method;
    std::string_view path;
    Who who;
    About about;
    ReplyOrRefusal (Portal::*answer)(const Call& call);
  };
  static std::span<const Route> routes();

  // The function for web::Site::desk.
  std::optional<web::Reply> answer(const web::Request& request, const web::Body& body);

  // The friendlies, for their runner.
  FriendlyDesk& friendlies() { return friendlies_; }

  // Marks the next hand-in as being checked and returns that hand-in; nothing if no check may
  // begin.
  std::optional<HandedIn> begin_next();
  bool has_next();

  void set_step(const std::string& team, int entry, const CheckStep& step);

  // To be called when a check has ended and its verdict is beside the entry: writes the answer, and
  // does what follows from it.
  Result<Submission> conclude(const std::string& team, int entry);

  // Writes an answer into the book.
  Result<void> close(const Answered& answer);

  // To be called when a check has ended without an answer: the hand-in waits for another check.
  // After some failures of the host the hand-in is void. If its check has used up its processor
  // time, `seconds`, for the second time, the hand-in is refused.
  Result<void> wait_again(const std::string& team, int entry, NoAnswer why = NoAnswer::host_failed,
                          double seconds = 0.0);

  // Calls HandIns::to_stop().
  std::optional<HandedIn> to_stop(const std::vector<RunningCheck>& running);

 private:
  Portal(system::Files& files, Folder folder, PortalLeague& league, PortalOptions options,
         Book book, system::FileLock lock);
  Result<void> follow_book();
  Result<void> refresh();
  Result<void> note_answer(const std::string& team, int entry);

  web::Reply reply_of(const Route& route, const Call& call);
  std::optional<web::Reply> admit(Call& call, bool is_page);
  std::optional<web::Reply> name_team(Call& call, About about);
  tl::expected<Json, web::Reply> entry_of(const Call& call);
  Json released_mark(const std::string& team) const;
  ReplyOrRefusal team_page(const std::string& team, int before);
  Json progress(const std::string& team, const Json& friendlies) const;

  // The handlers of routes().
  ReplyOrRefusal about_team(const Call& call);
  ReplyOrRefusal list_entries(const Call& call);
  ReplyOrRefusal take(const Call& call);
  ReplyOrRefusal show_entry(const Call& call);
  ReplyOrRefusal tell_entry(const Call& call);
  ReplyOrRefusal pin(const Call& call);
  ReplyOrRefusal list_legs(const Call& call);
  ReplyOrRefusal show_log(const Call& call);
  ReplyOrRefusal list_friendlies(const Call& call);
  ReplyOrRefusal ask_friendly(const Call& call);
  ReplyOrRefusal show_friendly(const Call& call);
  ReplyOrRefusal lead_to_desk(const Call& call);
  ReplyOrRefusal desk(const Call& call);
  ReplyOrRefusal entry_page_of(const Call& call);
  ReplyOrRefusal entry_replay(const Call& call);
  ReplyOrRefusal own_replay(const Call& call);
  ReplyOrRefusal mark_replay(const Call& call);
  ReplyOrRefusal log_in(const Call& call);
  ReplyOrRefusal log_out(const Call& call);
  ReplyOrRefusal act(const Call& call);
  ReplyOrRefusal grades(const Call& call);

  system::FileLock lock_;  // of the one server that takes hand-ins
  DeskState state_;
  Entries entries_;
  Uploads uploads_;
  const StaffDesk staff_;
  FriendlyDesk friendlies_;
  Doorkeeper doorkeeper_;  // guarded by the mutex of the state
};

}  // namespace mirocup::league
