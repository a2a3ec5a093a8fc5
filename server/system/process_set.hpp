// SPDX-License-Identifier: MIT
//
// Child processes that run at the same time, and one wait for whichever ends first. They die with
// this process.
#pragma once

#include "core/base/error.hpp"
#include "server/system/child_process.hpp"

#include <optional>
#include <string>
#include <sys/types.h>
#include <vector>

namespace mirocup::system {

// How a child ended.
struct Exit {
  int tag = 0;     // given at its start
  int code = 0;    // exit code, or
  int signal = 0;  // the signal that it died of
};

class ProcessSet {
 public:
  // SIGINT and SIGTERM are taken by wait() from here on.
  ProcessSet();
  ~ProcessSet();  // kills what is left
  ProcessSet(const ProcessSet&) = delete;
  ProcessSet& operator=(const ProcessSet&) = delete;

  // Runs arguments[0], a path or a name on the PATH, on that processor (-1: any); its output and errors
  // go to the file `log`. A program that is not there ends with code not_found.
  Result<pid_t> start(const std::vector<std::string>& arguments, int tag, int cpu,
                      const std::string& log);

  std::size_t running() const { return children_.size(); }

  // Waits for the next to end; nothing if a signal asks to stop. At least one must run.
  std::optional<Exit> wait();

  // Waits so many seconds (0: looks), whatever the children do; true as soon as a signal asks to stop.
  bool is_asked_to_stop_within(double seconds);

  // Ends one and forgets it.
  void kill(pid_t pid);

 private:
  struct Running {
    pid_t pid;
    int tag;
  };
  std::vector<Running> children_;
};

// The processors that this process may use.
std::vector<int> processors();

}  // namespace mirocup::system
