// SPDX-License-Identifier: MIT
#include "plugins/host/mailbox.hpp"

#include <cassert>
#include <ctime>
#include <linux/futex.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace mirocup::plugins {

void wait_while_equal(const std::atomic<std::uint32_t>& word, std::uint32_t seen,
                      std::optional<std::chrono::nanoseconds> timeout) {
  timespec limit{};
  if (timeout) {
    const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(*timeout);
    limit = {.tv_sec = seconds.count(), .tv_nsec = (*timeout - seconds).count()};
  }
  // Not FUTEX_PRIVATE_FLAG: the other side is another process.
  syscall(SYS_futex, &word, FUTEX_WAIT, seen, timeout ? &limit : nullptr, nullptr, 0);
}

void wake(const std::atomic<std::uint32_t>& word) {
  syscall(SYS_futex, &word, FUTEX_WAKE, 1, nullptr, nullptr, 0);
}

void wake(const std::atomic<std::uint32_t>& one, const std::atomic<std::uint32_t>& other) {
  // FUTEX_WAKE_OP is the only call that wakes on two words. It also changes the second one, by
  // adding 0, and wakes its sleeper if it was not 0.
  assert(other.load(std::memory_order_relaxed) != 0);
  const auto always = FUTEX_OP(FUTEX_OP_ADD, 0, FUTEX_OP_CMP_NE, 0);
  syscall(SYS_futex, &one, FUTEX_WAKE_OP, 1, 1, &other, always);
}

}  // namespace mirocup::plugins
