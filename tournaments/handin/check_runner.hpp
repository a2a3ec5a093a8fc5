// SPDX-License-Identifier: MIT
//
// Runs the checks of the hand-ins that wait, each in a child process: `mirocup-league
// check-hand-in`. If a child is killed, or dies with this process, the hand-in waits again. The
// runner plays friendlies while no hand-in waits, and stops them when a hand-in comes.
//
// The runner measures the use of each check a few times a second. If a check, with all programs
// that it starts, uses up the processor time of CheckLimits, the runner stops the check and begins
// it once more. After the second such stop the hand-in is refused. A check that takes long gives
// way to others (hand_ins.hpp).
//
// Threads: only the thread that uses the ProcessSet.
#pragma once

#include "system/process_set.hpp"
#include "tournaments/handin/friendly_runner.hpp"
#include "tournaments/handin/portal.hpp"

#include <chrono>
#include <functional>
#include <optional>
#include <set>

namespace mirocup::league {

struct CheckLimits {
  // Processor time of a check, s. The check of a source gets the time of CompileTime in addition. A
  // check of a team that is nearly as slow as it may be takes 60 s on a busy machine
  // (programs/check/check_plan.hpp).
  double processor = 90.0;
  // Wall time, s. If a check takes longer, the host gave it too little processor time, which counts
  // as the host's fault.
  double clock = 900.0;
};

// The limit of processor time for compiling a source of a team, s. If a source of the team was not
// compiled within `after_slow_one`, the team's sources get only this time until one of them is
// compiled.
class CompileTime {
 public:
  static constexpr int usual = 60;
  static constexpr int after_slow_one = 20;

  int of(const std::string& team) const { return slow_.contains(team) ? after_slow_one : usual; }

  // Notes whether a source was compiled, and the processor time that its compiler used.
  void note(const std::string& team, bool is_compiled, double used) {
    if (is_compiled) {
      slow_.erase(team);
    } else if (used >= 0.9 * after_slow_one) {
      slow_.insert(team);
    }
  }

 private:
  std::set<std::string> slow_;  // teams whose sources get only `after_slow_one`
};

class CheckRunner {
 public:
  // `tell` gets a line for the host about each answer. All arguments must outlive the runner.
  CheckRunner(system::Files& files, Folder folder, Portal& portal, system::ProcessSet& processes,
              int jobs, std::function<void(const std::string& line)> tell,
              const CheckLimits& limits = {});

  // Starts checks, books checks that have ended, and waits a short time for the next to end.
  // Returns false if this process is asked to stop.
  bool step();

 private:
  struct Running {
    HandedIn handed;
    pid_t pid = 0;
    std::chrono::steady_clock::time_point begun;
    int compile_seconds = 0;                         // limit of compiling; 0: the file is a library
    RunningCheck used{};                             // use of the check so far
    bool is_compiled = false;                        // the library exists, and its check has begun
    std::optional<NoAnswer> stopped = std::nullopt;  // why the runner stopped the check
  };

  // The number of checks and friendlies that run.
  int busy() const { return static_cast<int>(running_.size()) + friendlies_.running(); }

  void start_checks();
  void start_next();
  void book(const Running& check, const system::Exit& exit);
  void look_at_checks();
  void make_room(const std::vector<RunningCheck>& uses);
  Result<void> book_no_answer(const Running& check, const system::Exit& exit,
                              const std::string& said);
  double most_processor(const Running& check) const {
    return limits_.processor + check.compile_seconds;
  }
  std::string log_of(const HandedIn& handed) const;

  system::Files& files_;
  Folder folder_;
  Portal& portal_;
  system::ProcessSet& processes_;
  int jobs_;
  std::function<void(const std::string& line)> tell_;
  CheckLimits limits_;
  CompileTime compile_time_;
  std::map<int, Running> running_;  // the running checks by the tag of their process
  FriendlyRunner friendlies_;
  int next_tag_ = 0;
  std::chrono::steady_clock::time_point last_look_{};
  // After a fault of the host no check begins before this time.
  std::chrono::steady_clock::time_point rests_until_{};
};

}  // namespace mirocup::league
