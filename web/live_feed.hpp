// SPDX-License-Identifier: MIT
//
// The feed of a running match for its viewers. The feed holds only the latest state, not a queue.
// The match never waits for a viewer; a slow viewer misses states.
//
// Threads: the thread of the match calls publish() and close(); any other thread may call news().
#pragma once

#include "record/statistics/counter.hpp"
#include "web/track_encoder.hpp"

#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace mirocup::web {

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

}  // namespace mirocup::web
