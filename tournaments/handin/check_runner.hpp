// SPDX-License-Identifier: MIT
//
// Runs the checks of the hand-ins that wait, each in a child process: `mirocup-league
// check-hand-in`. A child may be killed at any moment, or die with this process; then its hand-in
// waits again. Friendlies are played when no hand-in waits.
//
// Threads: the one that uses the ProcessSet.
#pragma once

#include "system/process_set.hpp"
#include "tournaments/handin/friendly_runner.hpp"
#include "tournaments/handin/portal.hpp"

#include <chrono>
#include <functional>

namespace mirocup::league {

class CheckRunner {
 public:
  // `tell` gets a line for the host about each answer. All must outlive the runner.
  CheckRunner(system::Files& files, Folder folder, Portal& portal, system::ProcessSet& processes,
              int jobs, std::function<void(const std::string& line)> tell);

  // Starts checks, books the ends of checks, and waits for the next for a short time. Returns false
  // if this process is asked to stop.
  bool step();

 private:
  struct Running {
    WaitingHandIn handed;
    pid_t pid = 0;
    std::chrono::steady_clock::time_point begun;
  };

  // Processes that run.
  int busy() const { return static_cast<int>(running_.size()) + friendlies_.running(); }

  void start_checks();
  void start_next();
  void book(const Running& check, const system::Exit& exit);
  void look_at_steps();
  std::string output_of(const WaitingHandIn& handed) const;

  system::Files& files_;
  Folder folder_;
  Portal& portal_;
  system::ProcessSet& processes_;
  int jobs_;
  std::function<void(const std::string& line)> tell_;
  std::map<int, Running> running_;  // by tag
  FriendlyRunner friendlies_;
  int next_tag_ = 0;
  std::chrono::steady_clock::time_point steps_read_at_{};
  std::chrono::steady_clock::time_point rests_until_{};  // after a fault of the host
};

// The body of `check-hand-in`: checks one hand-in and prints the answer as JSON. The exit code is
// that of `submit`.
Result<int> check_hand_in(system::Files& files, const Folder& folder, const std::string& team,
                          int entry, const std::string& file, std::int64_t at);

}  // namespace mirocup::league
