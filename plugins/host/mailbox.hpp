// SPDX-License-Identifier: MIT
//
// The two pages that a match server and a team's process share.
//
// The server writes the observation page and the team only reads it; the team writes the command
// page and the server trusts nothing in it: it copies an answer once and checks the copy. A word on
// each page counts up and is waited for with a futex, so handing over costs one wake-up and no copy
// through the kernel.
#pragma once

#include "mirocup/strategy.h"

#include <atomic>
#include <chrono>
#include <cstdint>
#include <optional>

namespace mirocup::plugins {

static_assert(std::atomic<std::uint32_t>::is_always_lock_free);

struct ObservationPage {
  std::atomic<std::uint32_t> request;     // counts the observations, from 1
  std::atomic<std::uint32_t> is_awaited;  // 1 while the server sleeps until the answer comes
  mirocup_setup setup;
  mirocup_observation observation;
};

// What a team's process says of its library before the first answer. Only a label: the process
// could write anything here, so it can only ever cost its own team the leg.
enum class LoadState : std::uint32_t { loading, ready, no_load, bad_abi, crash };

// Exit codes of the team's process that come with something on its page.
inline constexpr int exit_refused = 1;  // load_state and text
inline constexpr int exit_faulted = 3;  // fault_signal and fault_call

inline constexpr int no_call = -1;

struct CommandPage {
  std::atomic<std::uint32_t> answer;  // the request that was answered last
  std::atomic<LoadState> load_state;
  std::atomic<int> fault_signal;  // 0: none
  std::atomic<int> fault_call;    // number of a forbidden system call, or no_call
  char text[256];                 // why it does not play, or what it threw
  mirocup_command command;
  mirocup_placement placement;  // while the observation says that the team places
};

// Sleeps until the word is no longer `seen`, it is woken, or the time is over. May return early.
// Without a time it sets no timer.
void wait_while_equal(const std::atomic<std::uint32_t>& word, std::uint32_t seen,
                      std::optional<std::chrono::nanoseconds> timeout = std::nullopt);
void wake(const std::atomic<std::uint32_t>& word);
// Both, before either runs on this core. The other word must be writable here, and not 0.
void wake(const std::atomic<std::uint32_t>& one, const std::atomic<std::uint32_t>& other);

}  // namespace mirocup::plugins
