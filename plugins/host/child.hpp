// SPDX-License-Identifier: MIT
//
// A child process: its exit status, processor time and memory.
#pragma once

#include <ctime>
#include <optional>
#include <string>
#include <sys/types.h>

namespace mirocup::plugins {

// How a process ended.
struct ExitStatus {
  int exit_code = 0;
  int signal = 0;  // 0: the process exited by itself
};

// Returns a signal in words: "signal 11 (Segmentation fault)".
std::string signal_text(int signal);

// Owns a child process. Threads: one.
class Child {
 public:
  // Takes over a process that this process has forked.
  explicit Child(pid_t pid);
  Child(Child&& other) noexcept;
  Child& operator=(Child&&) = delete;
  ~Child();  // kills and reaps the process

  // Returns how the process ended, or nothing while the process runs. Never waits.
  std::optional<ExitStatus> exit_status();

  // Sends SIGKILL and returns when the process is gone. In a process namespace this call also ends
  // every process that the child has started.
  void kill();

  // Returns the processor time that the process has used, s. After the end of the process, returns
  // the value of the last call.
  double cpu_seconds();

  // Returns how long the process was ready to run but had no processor, s; nothing if the kernel
  // does not give the time.
  std::optional<double> processor_delay() const { return processor_delay(pid_); }
  static std::optional<double> processor_delay(pid_t pid);

  // Returns the peak of the process's memory in use, bytes, also after the end of the process.
  std::size_t peak_memory() const;

 private:
  bool reap(int options);

  pid_t pid_;
  clockid_t cpu_clock_ = 0;
  double cpu_ = 0.0;             // s
  std::size_t peak_memory_ = 0;  // bytes; 0 while the process runs
  std::optional<ExitStatus> exit_status_;
};

}  // namespace mirocup::plugins
