// SPDX-License-Identifier: MIT
//
// A match that is being played, as its viewers get it: always the latest state, never a queue. The
// match hands over and goes on; a viewer that is slow misses states, and nobody waits for it.
//
// Threads: publish() and close() belong to the thread of the match, news() to any other.
#pragma once

#include "server/web/statistics.hpp"
#include "server/web/track_encoder.hpp"

#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace mirocup::web {

class LiveFeed {
 public:
  explicit LiveFeed(const match::Leg& match);

  // After every tick: copies the state, unless a viewer is being served in this very moment.
  void publish(const match::Leg& match);

  // The match is over: from here on news() ends.
  void close(const match::Leg& match);

  // What one viewer has been told.
  struct Viewer {
    bool has_started = false;
    bool has_ended = false;
    std::size_t decisions = 0;
    std::uint64_t version = 0;     // of the state
    std::uint64_t statistics = 0;  // version in which it got the numbers
    Frame frame;
  };

  // Server-sent events that bring the viewer up to date; "" if it is.
  std::string news(Viewer& viewer) const;

 private:
  void copy(const match::Leg& match);

  int robots_;
  Statistics counted_;  // the match's own

  mutable std::mutex mutex_;
  std::uint64_t version_ = 1;
  match::Snapshot scene_;
  std::vector<match::LoggedDecision> decisions_;
  Statistics statistics_;  // as far as they are shown
  std::optional<match::Outcome> result_;
};

}  // namespace mirocup::web
