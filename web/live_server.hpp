// SPDX-License-Identifier: MIT
//
// The live page of one match over HTTP: the page at / and its events at /events. No request changes
// anything, and the server reads no file.
//
// Threads: the server runs in separate threads, with a lower priority than the match. A viewer that
// does not read blocks its own thread only, and is dropped after a few seconds. Only the thread of
// the match may call the functions.
#pragma once

#include "core/base/error.hpp"
#include "record/statistics/counter.hpp"
#include "web/http/server.hpp"
#include "web/page.hpp"
#include "web/track_encoder.hpp"

#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace mirocup::web {

// The feed of a running match for its viewers. The feed holds only the latest state, not a queue.
// The match never waits for a viewer; a slow viewer misses states.
//
// Threads: the thread of the match calls publish() and close(); any other thread may call news().
class LiveFeed {
 public:
  explicit LiveFeed(const match::Leg& match);

  // To be called after every tick. Copies the state, unless a viewer is reading it at that moment.
  void publish(const match::Leg& match);

  // To be called when the match is over. The next news() of each viewer is its last.
  void close(const match::Leg& match);

  // The state of one viewer: the events that the viewer has already received.
  struct Viewer {
    bool has_started = false;
    bool has_ended = false;
    std::size_t decisions = 0;
    std::uint64_t version = 0;     // version of the state that the viewer has
    std::uint64_t statistics = 0;  // version of the viewer's statistics
    Frame frame;
  };

  // Returns the server-sent events that bring the viewer up to date; "" if it is up to date.
  std::string news(Viewer& viewer) const;

 private:
  void copy(const match::Leg& match);

  int robots_;
  // The counts up to the present tick; only the thread of the match uses them.
  statistics::LegCounter counted_;

  mutable std::mutex mutex_;
  std::uint64_t version_ = 1;
  match::Snapshot scene_;
  std::vector<match::LoggedDecision> decisions_;
  statistics::LegCounter statistics_;  // statistics at version_
  std::optional<match::Outcome> result_;
};

class LiveServer {
 public:
  // `about` is the last line of the page. Errc::unavailable if the address is in use or does not
  // belong to this host.
  static Result<std::unique_ptr<LiveServer>> open(const Address& address, const match::Leg& match,
                                                  const match::ByTeam<std::string>& names,
                                                  const std::string& about);

  std::string url() const { return http_.url(); }
  int port() const { return http_.port(); }

  // To be called after every tick.
  void publish(const match::Leg& match) { feed_.publish(match); }

  // Sends the result to the viewers, and waits at most 1.5 s for them to receive it.
  void close(const match::Leg& match);

 private:
  LiveServer(const match::Leg& match, std::string page) : feed_(match), page_(std::move(page)) {}
  Reply answer(const Request& request);

  LiveFeed feed_;
  const std::string page_;
  // The first to go: its threads use the others.
  HttpServer http_{[this](const Request& request, const Body&) { return answer(request); }, {}};
};

}  // namespace mirocup::web
