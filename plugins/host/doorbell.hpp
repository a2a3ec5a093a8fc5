// SPDX-License-Identifier: MIT
//
// Wakes the processes of both teams of a match together.
//
// If the server woke one process after the other, the first would take the core at once, answer and
// sleep before the server could wake the second: four context switches in a tick. One system call
// that wakes both processes makes them three. The teams share no memory for this.
#pragma once

#include "plugins/host/mailbox.hpp"

#include <algorithm>
#include <array>
#include <cassert>

namespace mirocup::plugins {

// The doorbell of one match, shared by the controllers of its teams. Threads: the match's thread.
class Doorbell {
 public:
  // A team, of at most two, joins when its process starts and leaves when the process is gone.
  void join() {
    assert(members_ < 2);
    ++members_;
  }
  void leave() {
    assert(members_ > 0);
    --members_;
  }

  // Asks for a wake-up of the process that sleeps on `word`. All sleepers are woken when every
  // member has asked, or at the next ring(). The word must live until the wake-up.
  void ask(const std::atomic<std::uint32_t>& word) {
    assert(asked_ < 2);
    words_[static_cast<std::size_t>(asked_++)] = &word;
    if (asked_ >= std::min(members_, 2)) ring();
  }

  // Wakes the processes for which a wake-up was asked. Must be called before waiting for an answer:
  // while one team still computes, only the other team's wake-up is asked for, and ask() alone
  // would not wake it.
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
