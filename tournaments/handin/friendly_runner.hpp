// SPDX-License-Identifier: MIT
//
// Plays the friendlies that wait, each in a child process of low priority: `mirocup-league
// play-friendly`. If a child is killed, its leg is played again.
//
// Threads: only the thread that uses the ProcessSet.
#pragma once

#include "system/process_set.hpp"
#include "tournaments/handin/friendly_desk.hpp"

#include <chrono>

namespace mirocup::league {

class FriendlyRunner {
 public:
  // All arguments must outlive the runner.
  FriendlyRunner(Folder folder, FriendlyDesk& desk, system::ProcessSet& processes)
      : folder_(std::move(folder)), desk_(desk), processes_(processes) {}

  // Starts the next leg as a process with the tag `tag`. Returns false if no leg waits, or if this
  // computer cannot start a process now.
  bool start_next(int tag);

  // Books the end of the leg whose process has ended. Returns false if the process is not a leg.
  bool book(const system::Exit& exit);

  // Kills legs that take too long.
  void look_at_time();

  // Stops a leg that has taken some seconds, so that a check can begin. The leg is played again
  // later. Returns false if no leg has taken so long.
  bool give_way();

  int running() const { return static_cast<int>(running_.size()); }

 private:
  struct Running {
    Friendly friendly;
    pid_t pid = 0;
    std::chrono::steady_clock::time_point begun;
    bool gives_way = false;  // the runner stopped the leg for a check
  };

  Folder folder_;
  FriendlyDesk& desk_;
  system::ProcessSet& processes_;
  std::map<int, Running> running_;  // the running legs by the tag of their process
};

}  // namespace mirocup::league
