// SPDX-License-Identifier: MIT
//
// A child process: how it ended, what it used.
#pragma once

#include <ctime>
#include <optional>
#include <string>
#include <sys/types.h>

namespace mirocup::plugins {

// How a process ended by itself.
struct ExitStatus {
  int exit_code = 0;
  int signal = 0;  // 0: it exited
};

// "signal 11 (Segmentation fault)"
std::string signal_text(int signal);

class Child {
 public:
  // Takes over a process that was forked here.
  explicit Child(pid_t pid);
  Child(Child&& other) noexcept;
  Child& operator=(Child&&) = delete;
  ~Child();  // kills and reaps

  // How it ended, or nothing while it runs.
  std::optional<ExitStatus> exit_status();

  // Ends it, and in a process namespace all that it started; returns when it is gone.
  void kill();

  // Processor time that it has used, s; after its end what it had at the last question.
  double cpu_seconds();

  // How long it could have run but had no processor, s; nothing where the kernel does not say.
  std::optional<double> processor_delay() const { return processor_delay(pid_); }
  static std::optional<double> processor_delay(pid_t pid);

  // The most memory that it had in use so far, bytes; 0 once it is gone.
  std::size_t peak_memory() const;

 private:
  pid_t pid_;
  clockid_t cpu_clock_ = 0;
  double cpu_ = 0.0;
  std::optional<ExitStatus> exit_status_;
};

}  // namespace mirocup::plugins
