// SPDX-License-Identifier: MIT
#include "plugins/host/fault_report.hpp"

#include "plugins/host/sandbox/signals.hpp"

#include <algorithm>
#include <csignal>
#include <iterator>
#include <unistd.h>

namespace mirocup::plugins {

namespace {

// A global variable, because a signal handler gets no pointer of its own.
CommandPage* faulted_page = nullptr;

alignas(16) char stack[32 << 10];

// The codes of signals that the kernel sends are greater than 0. What another process sends, such
// as the SIGTERM for all processes of a job, is the host's affair: the server ends the leg.
bool is_from_another_process(const siginfo_t& info) {
  return info.si_code <= 0 && info.si_pid != getpid();
}

void report(int signal, siginfo_t* info, void*) {
  if (is_from_another_process(*info)) return;
  faulted_page->fault_call.store(signal == SIGSYS ? info->si_syscall : no_call,
                                 std::memory_order_relaxed);
  faulted_page->fault_signal.store(signal, std::memory_order_release);
  _exit(exit_faulted);
}

}  // namespace

bool report_faults_to(CommandPage& page) {
  faulted_page = &page;
  stack_t alternative{};
  alternative.ss_sp = stack;
  alternative.ss_size = sizeof stack;
  if (sigaltstack(&alternative, nullptr) != 0) return false;
  struct sigaction action {};
  action.sa_sigaction = report;
  action.sa_flags = SA_SIGINFO | SA_ONSTACK | SA_RESTART;
  const auto handle = [&action](int signal) { return sigaction(signal, &action, nullptr) == 0; };
  sigset_t none;
  sigemptyset(&none);
  return handle(SIGSYS) &&
         std::all_of(std::begin(processor_signals), std::end(processor_signals), handle) &&
         std::all_of(std::begin(ending_signals), std::end(ending_signals), handle) &&
         sigprocmask(SIG_SETMASK, &none, nullptr) == 0;
}

}  // namespace mirocup::plugins
