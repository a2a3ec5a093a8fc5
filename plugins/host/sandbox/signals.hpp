// SPDX-License-Identifier: MIT
//
// Signals in a team's process.
//
// In tier T2 a team is the first process of a namespace, and the kernel shields such a process from
// signals for which it has no handler. So that a team ends in the same way in both tiers, every
// signal that ends a process has a handler (fault_report.hpp), which the team cannot remove
// (filter.hpp).
#pragma once

#include <csignal>

namespace mirocup::plugins {

// Signals that end a process, whether the process itself or another process sends the signal.
inline constexpr int ending_signals[] = {SIGHUP,  SIGINT,  SIGQUIT,   SIGABRT, SIGPIPE, SIGALRM,
                                         SIGTERM, SIGUSR1, SIGUSR2,   SIGXCPU, SIGXFSZ, SIGVTALRM,
                                         SIGPROF, SIGIO,   SIGSTKFLT, SIGPWR};

// Signals that the processor raises. Run-time libraries of some languages handle them, which is
// allowed. The kernel never shields a process from such signals.
inline constexpr int processor_signals[] = {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGTRAP};

// Signals that stop a process, or with which the host ends a process. A team cannot send these
// signals.
inline constexpr int signals_of_the_host[] = {SIGKILL, SIGSTOP, SIGTSTP, SIGTTIN, SIGTTOU};

}  // namespace mirocup::plugins
