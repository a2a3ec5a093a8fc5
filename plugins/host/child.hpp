// SPDX-License-Identifier: MIT
//
// A child process that dies with its parent, and tells how it died.
#pragma once

#include "core/base/error.hpp"

#include <optional>
#include <string>
#include <sys/types.h>
#include <vector>

namespace mirocup::plugins {

// How a process ended by itself.
struct Ending {
  int exit_code = 0;
  int signal = 0;  // 0: it exited

  std::string text()
      const;  // "ended itself with exit code 3", "died of signal 11 (Segmentation fault)"
};

class Child {
 public:
  // Runs `program` with the arguments, an empty input, `output` as its output and error output, and
  // the listed descriptors under their own numbers; everything else is closed. Its environment is
  // fixed.
  static Result<Child> start(const std::string& program, const std::vector<std::string>& arguments,
                             const std::vector<int>& descriptors, int output);

  Child(Child&& other) noexcept;
  Child& operator=(Child&&) = delete;
  ~Child();  // kills and reaps

  pid_t pid() const { return pid_; }

  // How it ended, or nothing while it runs.
  std::optional<Ending> ending();

  // Ends it and all it started in its session; returns when it is gone.
  void kill();

  // Processor time that it has used, s.
  double cpu_seconds() const;

 private:
  explicit Child(pid_t pid);

  pid_t pid_;
  int cpu_clock_ = 0;
  std::optional<Ending> ending_;
};

}  // namespace mirocup::plugins
