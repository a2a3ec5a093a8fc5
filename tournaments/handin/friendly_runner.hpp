// SPDX-License-Identifier: MIT
//
// Plays the friendlies that wait, each in a child process of low priority: `mirocup-league
// play-friendly`. If a child is killed, its leg is played again.
//
// Threads: the one that uses the ProcessSet.
#pragma once

#include "system/process_set.hpp"
#include "tournaments/handin/friendly_desk.hpp"

#include <chrono>

namespace mirocup::league {

class FriendlyRunner {
 public:
  // All must outlive the runner.
  FriendlyRunner(Folder folder, FriendlyDesk& desk, system::ProcessSet& processes)
      : folder_(std::move(folder)), desk_(desk), processes_(processes) {}

  // Starts the next leg as a process with that tag. Returns false if no leg waits, or if this
  // computer cannot start a process now.
  bool start_next(int tag, std::int64_t now);

  // Books the end of a leg. Returns false if no leg has this tag.
  bool book(const system::Exit& exit, std::int64_t now);

  // Kills legs that take too long.
  void look_at_time();

  // Stops a leg that has taken some seconds, so that a check can begin; the leg is played again
  // later. Returns false if there is no such leg.
  bool give_way();

  int running() const { return static_cast<int>(running_.size()); }

 private:
  struct Running {
    Friendly friendly;
    pid_t pid = 0;
    std::chrono::steady_clock::time_point begun;
    bool gives_way = false;  // it was stopped
  };

  Folder folder_;
  FriendlyDesk& desk_;
  system::ProcessSet& processes_;
  std::map<int, Running> running_;  // by tag
};

}  // namespace mirocup::league
