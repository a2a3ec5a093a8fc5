// SPDX-License-Identifier: MIT
//
// Child processes that run at the same time, and a wait for the first child that ends. The kernel
// kills the children when this process ends.
//
// One thread uses a ProcessSet. Create it before any other thread, because other threads must not
// receive the signals that it waits for.
#pragma once

#include "core/base/error.hpp"
#include "system/child_process.hpp"

#include <chrono>
#include <optional>
#include <string>
#include <sys/types.h>
#include <vector>

namespace mirocup::system {

// The end of a child process.
struct Exit {
  int tag = 0;     // the tag given at its start
  int code = 0;    // the exit code, if no signal ended it
  int signal = 0;  // the signal that ended it, or 0
};

class ProcessSet {
 public:
  // Blocks SIGINT, SIGTERM and SIGCHLD from now on; only the waiting functions receive them.
  ProcessSet();
  ~ProcessSet();  // kills the children that still run
  ProcessSet(const ProcessSet&) = delete;
  ProcessSet& operator=(const ProcessSet&) = delete;

  // Starts the program arguments[0], a path or a name on the PATH, on processor `cpu` (-1: any).
  // Its output and errors go to the file `log`. If the program does not exist, the child ends with
  // code not_found. When the child ends, all processes of its group are killed. A child whose time
  // is over ends by SIGKILL while the set waits.
  Result<pid_t> start(const std::vector<std::string>& arguments, int tag, int cpu,
                      const std::string& log, const ChildLimits& limits = {});

  std::size_t running() const { return children_.size(); }

  // Waits for the next child to end. Returns nothing if SIGINT or SIGTERM arrives first. At least
  // one child must run.
  std::optional<Exit> wait();

  // Waits at most a given time for the next child to end, or for SIGINT or SIGTERM.
  struct News {
    std::optional<Exit> exit;
    bool is_asked_to_stop = false;
  };
  News wait_within(double seconds);

  // Waits for a given time, even if children end. Returns true as soon as SIGINT or SIGTERM
  // arrives. With 0 s, returns at once, true if a signal has arrived.
  bool is_asked_to_stop_within(double seconds);

  // Kills one child with its group, and waits for its end, which wait() will not report.
  void kill(pid_t pid);

 private:
  struct Running {
    pid_t pid;
    int tag;
    std::chrono::time_point<std::chrono::steady_clock, std::chrono::duration<double>> end;
  };
  // Returns the end of a child that has ended already.
  std::optional<Exit> ended();

  std::vector<Running> children_;
};

// Returns the processors that this process may use; {-1} if the system does not say.
std::vector<int> processors();

// Keeps the calling thread on one processor.
void stay_on(int processor);

}  // namespace mirocup::system
