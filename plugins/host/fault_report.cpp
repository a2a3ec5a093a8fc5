// SPDX-License-Identifier: MIT
#include "plugins/host/fault_report.hpp"

#include <csignal>
#include <unistd.h>

namespace mirocup::plugins {

namespace {

// A global variable, because a signal handler gets no pointer of its own.
CommandPage* faulted_page = nullptr;

alignas(16) char stack[32 << 10];

void report(int signal, siginfo_t* info, void*) {
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
  action.sa_flags = SA_SIGINFO | SA_ONSTACK;
  for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGSYS}) {
    if (sigaction(signal, &action, nullptr) != 0) return false;
  }
  return true;
}

}  // namespace mirocup::plugins
