// SPDX-License-Identifier: MIT
#include "system/interrupt.hpp"

#include <csignal>
#include <ctime>

namespace mirocup::system {

namespace {

sigset_t signals() {
  sigset_t set;
  sigemptyset(&set);
  sigaddset(&set, SIGINT);
  sigaddset(&set, SIGTERM);
  return set;
}

}  // namespace

Interrupt::Interrupt() {
  const sigset_t set = signals();
  pthread_sigmask(SIG_BLOCK, &set, nullptr);
}

bool Interrupt::is_asked_for() {
  const sigset_t set = signals();
  const timespec no_wait{0, 0};
  if (!asked_ && sigtimedwait(&set, nullptr, &no_wait) > 0) asked_ = true;
  return asked_;
}

}  // namespace mirocup::system
