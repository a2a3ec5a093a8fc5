// SPDX-License-Identifier: MIT
#include "plugins/host/memory_witness.hpp"

#include "system/memory.hpp"

namespace mirocup::plugins {

namespace {

using system::mebibytes;

// Memory that moves during any leg: caches, buffers, the server's record.
constexpr std::size_t noise = std::size_t{64} << 20;

// A process with less was not what the memory went to.
constexpr std::size_t much = system::memory_of_a_team / 2;

// True if the machine had room for both teams, and all that has gone since went to this one.
bool is_teams_fault(const MemoryEvidence& e) {
  if (e.was_out_of_memory != true || !e.free_at_start || !e.free_now) return false;
  const bool had_room = *e.free_at_start >= system::memory_of_a_leg;
  const bool others_took_it = *e.free_now + e.other_peak + noise < *e.free_at_start;
  return had_room && !others_took_it && e.own_peak > e.other_peak && e.own_peak >= much;
}

}  // namespace

match::Answer judge_kill(Team team, const MemoryEvidence& e) {
  const std::string name = "the " + std::string(to_string(team)) + " team's process";
  const std::string size = " when it had taken " + mebibytes(e.own_peak) + " of memory";
  const std::string room =
      (e.free_at_start ? mebibytes(*e.free_at_start) : std::string("an unknown number of MiB")) +
      " were free when the leg began, and a leg may take " + mebibytes(system::memory_of_a_leg);
  if (is_teams_fault(e)) {
    return match::Fault{match::FaultCode::crash, name + " was ended for want of memory" + size +
                                                     " and the other team's process " +
                                                     mebibytes(e.other_peak) + "; " + room};
  }
  if (e.was_out_of_memory == true) {
    return match::HostFailure{name + " was ended for want of memory" + size +
                              " and the other team's process " + mebibytes(e.other_peak) + "; " +
                              room};
  }
  return match::HostFailure{name + " was killed from outside" + size +
                            (e.was_out_of_memory == false
                                 ? ", and not for want of memory: a cancelled job, or a person"
                                 : ": out of memory, or a cancelled job; " + room)};
}

MemoryWitness::MemoryWitness()
    : free_at_start_(system::available_memory()), kills_at_start_(system::out_of_memory_kills()) {}

void MemoryWitness::remove(Team team) {
  peaks_[index_of(team)] = peak_of(team);
  children_[index_of(team)] = nullptr;
}

std::size_t MemoryWitness::peak_of(Team team) const {
  const Child* child = children_[index_of(team)];
  return child != nullptr ? child->peak_memory() : peaks_[index_of(team)];
}

MemoryEvidence MemoryWitness::evidence(Team team) const {
  MemoryEvidence evidence;
  if (const auto kills = system::out_of_memory_kills(); kills && kills_at_start_)
    evidence.was_out_of_memory = *kills > *kills_at_start_;
  evidence.free_at_start = free_at_start_;
  evidence.free_now = system::available_memory();
  evidence.own_peak = peak_of(team);
  evidence.other_peak = peak_of(opponent_of(team));
  return evidence;
}

}  // namespace mirocup::plugins
