// SPDX-License-Identifier: MIT
//
// Wakes the processes of a match's teams together.
//
// Woken one by one, the first would take the core at once, answer and sleep, before the server could
// wake the second: four changes of processes a tick. One call into the kernel for both makes three
// of them. The teams share no memory for it.
#pragma once

#include "plugins/host/mailbox.hpp"

#include <algorithm>
#include <array>

namespace mirocup::plugins {

// Of one match, used from its thread only.
class Doorbell {
 public:
  void join() { ++members_; }
  void leave() { --members_; }

  // Wakes who sleeps on the word, when every member has asked for that or at the next ring().
  void ask(const std::atomic<std::uint32_t>& word) {
    words_[static_cast<std::size_t>(asked_++)] = &word;
    if (asked_ >= std::min(members_, 2)) ring();
  }

  // Before waiting for an answer: a team that still thinks is not asked again, and the other one
  // would not be woken.
  void ring() {
    if (asked_ == 1) wake(*words_[0]);
    if (asked_ == 2) wake(*words_[0], *words_[1]);
    asked_ = 0;
  }

 private:
  int members_ = 0;
  int asked_ = 0;
  std::array<const std::atomic<std::uint32_t>*, 2> words_{};
};

}  // namespace mirocup::plugins
