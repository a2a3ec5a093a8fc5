// SPDX-License-Identifier: MIT
//
// The two memory pages that the match server and a team's process share.
//
// The server writes the observation page, and the team can only read it. The team writes the
// command page, and the server trusts nothing on that page: it copies an answer once and checks the
// copy. Each page has a counter on which the other side waits with a futex, so that a handover
// takes one wake-up and no copy through the kernel.
#pragma once

#include "mirocup/strategy.h"
#include "plugins/host/parameter_table.hpp"
#include "plugins/host/surroundings.hpp"
#include "plugins/host/thoughts_page.hpp"

#include <array>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <optional>

namespace mirocup::plugins {

inline constexpr std::size_t max_trace = 24;

// The calls in the team's library that were active at a crash, innermost first. Addresses are
// relative to the place where the library is loaded. The address of a calling
// function is inside its call instruction.
struct CrashTrace {
  std::uint32_t count = 0;
  std::array<std::uint64_t, max_trace> address;
};

static_assert(std::atomic<std::uint32_t>::is_always_lock_free);

struct ObservationPage {
  std::atomic<std::uint32_t> request;     // number of the observation, counted from 1
  std::atomic<std::uint32_t> is_awaited;  // 1 while the server sleeps until the team answers
  Surroundings surroundings;
  mirocup_setup setup;  // the pointers in it are null; the team's process sets its own pointers
  ParameterTable parameters;
  std::uint32_t keeps_thoughts;  // 1: the team's shapes are kept
  mirocup_observation observation;
};

// The report of a team's process about loading its library. The process can write anything here, so
// the server uses the report only as the reason if the team loses the leg.
enum class LoadState : std::uint32_t { loading, ready, no_load, bad_abi, crash };

// The exit codes of a team's process that left a report on its page. The comments name the members
// of CommandPage with that report.
inline constexpr int exit_refused = 1;  // load_state, refusal_line, cause and text
inline constexpr int exit_faulted = 3;  // fault_signal and the fields after it

inline constexpr int no_call = -1;

// The running function of the team; `none` while the library is being loaded.
enum class TeamCall : std::uint32_t { none, create, decide, place };

// The kind of address at which an access killed a process.
enum class AddressKind : std::uint32_t {
  unknown,
  null,
  end_of_stack,
  other,
  observation,
  lost  // invalid, and the crash was in no code of the team: for example, a return to nowhere
};

struct CommandPage {
  std::atomic<std::uint32_t> answer;  // the last request that was answered
  std::atomic<LoadState> load_state;
  std::atomic<int> refusal_line;  // Fault::line
  std::atomic<int> fault_signal;  // signal of the crash; 0: none
  std::atomic<int> fault_call;    // number of a forbidden system call, or no_call
  std::atomic<AddressKind> fault_address;
  std::atomic<std::uint32_t> fault_is_traced;  // 1: fault_trace is complete
  CrashTrace fault_trace;
  std::atomic<TeamCall> team_call;  // the team's function that runs or ran last
  AskedRows asked_parameters;       // the rows of ObservationPage::parameters that were asked for
  char name[64];                    // name of the team from its library; any bytes
  char text[256];                   // why the team does not play, or the text of its exception
  char cause[64];                   // Fault::cause; any bytes
  char requests[1024];              // output of write_requests(), only in mirocup-careful-host
  mirocup_command command;
  mirocup_placement placement;  // valid if the observation had placing = 1
  // Shapes of the answered tick, if the observation page asks for shapes.
  ThoughtsPage thoughts;
};

// Sleeps until the word differs from `seen`, wake() is called, or the timeout is over; may return
// early. Without a timeout, sets no timer.
void wait_while_equal(const std::atomic<std::uint32_t>& word, std::uint32_t seen,
                      std::optional<std::chrono::nanoseconds> timeout = std::nullopt);

// Wakes the process that sleeps on a word.
void wake(const std::atomic<std::uint32_t>& word);

// Wakes the sleepers on two words before either sleeper can run on this core. The value of `other`
// must not be 0, and its memory must be writable in this process.
void wake(const std::atomic<std::uint32_t>& one, const std::atomic<std::uint32_t>& other);

}  // namespace mirocup::plugins
