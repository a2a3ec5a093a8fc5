// SPDX-License-Identifier: MIT
//
// Decides who is to blame if a lack of memory ended a leg.
//
// If memory is short, the kernel kills a process of its choice with SIGKILL. A team that stayed
// within its limit is not at fault: the leg is void, and its reason names the memory of both teams.
// A team is at fault only if all of this holds: the kernel ended a process for lack of memory, the
// memory for a leg was free when the leg began, no other process has taken that memory since, and
// the team has taken more memory than the other team and at least half of its limit.
#pragma once

#include "core/field/team.hpp"
#include "core/match/controller.hpp"
#include "plugins/host/child.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

namespace mirocup::plugins {

// The evidence about a team's process that was killed from outside; sizes in bytes.
struct MemoryEvidence {
  // True: in this leg the kernel killed a process for lack of memory. Empty: not known.
  std::optional<bool> was_out_of_memory;
  std::optional<std::size_t> free_at_start;  // free memory when the leg began
  std::optional<std::size_t> free_now;       // free memory after the end of the process
  std::size_t own_peak = 0;                  // peak memory of the killed process
  std::size_t other_peak = 0;                // peak memory of the other team's process
};

// Returns the verdict on the evidence: a Fault of the team or a HostFailure.
match::Answer judge_kill(Team team, const MemoryEvidence& evidence);

// Watches the memory of one leg. The controllers of both teams share the object; each adds its
// Child, and removes it before the Child is destroyed.
class MemoryWitness {
 public:
  MemoryWitness();  // to be called when the leg begins

  void add(Team team, const Child& child) { children_[index_of(team)] = &child; }
  void remove(Team team);

  // Returns the evidence about the process of a team. Precondition: the process has ended.
  MemoryEvidence evidence(Team team) const;

 private:
  std::size_t peak_of(Team team) const;

  std::array<const Child*, 2> children_{};
  std::array<std::size_t, 2> peaks_{};  // memory peaks of removed processes
  std::optional<std::size_t> free_at_start_;
  std::optional<std::uint64_t> kills_at_start_;
};

}  // namespace mirocup::plugins
