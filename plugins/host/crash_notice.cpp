// SPDX-License-Identifier: MIT
#include "plugins/host/crash_notice.hpp"

#include <csignal>
#include <cstring>
#include <initializer_list>
#include <unistd.h>

namespace mirocup::plugins {

namespace {

// Not an argument, because a signal handler gets no pointer of its own. Of the thread: the handler
// runs in the one that has crashed.
thread_local const RunningCall* running_call = nullptr;

void print_part(const char* text) {
  (void)!write(STDERR_FILENO, text, std::strlen(text));
}

void print_number(std::uint32_t number) {
  char digits[12];
  char* first = digits + sizeof digits - 1;
  *first = '\0';
  do *--first = static_cast<char>('0' + number % 10);
  while ((number /= 10) > 0);
  print_part(first);
}

// Returns to the default action, of which the process then dies.
void tell_of_crash(int signal) {
  if (const RunningCall* call = running_call) {
    print_part("mirocup: the ");
    print_part(call->colour);
    print_part(" team crashed in this process, in ");
    print_part(call->function);
    print_part(" of tick ");
    print_number(call->tick);
    print_part(", by ");
    print_part(sigdescr_np(signal));
    print_part("; with gdb --args before the command, bt shows the line\n");
  }
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

}  // namespace

void tell_of_crashes() {
  for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT}) {
    struct sigaction present {};
    if (sigaction(signal, nullptr, &present) != 0 || present.sa_handler != SIG_DFL) continue;
    struct sigaction action {};
    action.sa_handler = tell_of_crash;
    sigaction(signal, &action, nullptr);
  }
}

RunningCallMark::RunningCallMark(const RunningCall& call) : call_(call) {
  running_call = &call_;
}

RunningCallMark::~RunningCallMark() {
  running_call = nullptr;
}

}  // namespace mirocup::plugins
