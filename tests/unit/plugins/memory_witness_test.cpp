// SPDX-License-Identifier: MIT
//
// Whose fault a process is that the kernel ended. Catches a host's shortage that becomes a team's
// loss.
#include "plugins/host/memory_witness.hpp"

#include "system/memory.hpp"

#include <gtest/gtest.h>

namespace mirocup::plugins {
namespace {

constexpr std::size_t mebibyte = std::size_t{1} << 20;

// A machine that had room for all that both teams may take, and where all that is missing went to
// this team.
MemoryEvidence against_the_team() {
  return {.was_out_of_memory = true,
          .free_at_start = system::memory_of_a_leg + 100 * mebibyte,
          .free_now = system::memory_of_a_leg + 70 * mebibyte,
          .own_peak = 900 * mebibyte,
          .other_peak = 20 * mebibyte};
}

bool is_fault(const MemoryEvidence& evidence) {
  return std::holds_alternative<match::Fault>(judge_kill(Team::yellow, evidence));
}

std::string text_of(const MemoryEvidence& evidence) {
  return std::get<match::HostFailure>(judge_kill(Team::yellow, evidence)).text;
}

TEST(JudgeKill, IsTheTeamsFaultIfAllTheMissingMemoryIsItsOwn) {
  const match::Answer answer = judge_kill(Team::yellow, against_the_team());
  ASSERT_TRUE(std::holds_alternative<match::Fault>(answer));
  EXPECT_EQ(std::get<match::Fault>(answer).text,
            "the yellow team's process was ended for want of memory when it had taken 900 MiB of "
            "memory and the other team's process 20 MiB; 2212 MiB were free when the leg began, "
            "and a leg may "
            "take 2112 MiB");
}

TEST(JudgeKill, IsTheHostsFailureIfOneConditionIsMissing) {
  MemoryEvidence small_host = against_the_team();
  small_host.free_at_start = system::memory_of_a_leg - 1;
  EXPECT_FALSE(is_fault(small_host));
  MemoryEvidence smaller_team = against_the_team();
  smaller_team.other_peak = smaller_team.own_peak;
  EXPECT_FALSE(is_fault(smaller_team));
  MemoryEvidence small_team = against_the_team();
  small_team.own_peak = 100 * mebibyte;
  EXPECT_FALSE(is_fault(small_team)) << "it was not what the memory went to";
  MemoryEvidence busy_host = against_the_team();
  busy_host.free_now = 900 * mebibyte;
  EXPECT_FALSE(is_fault(busy_host)) << "another program has taken it";
  MemoryEvidence killed = against_the_team();
  killed.was_out_of_memory = false;
  EXPECT_FALSE(is_fault(killed)) << "a person has killed it";
  const auto without = [](auto MemoryEvidence::*what) {
    MemoryEvidence evidence = against_the_team();
    (evidence.*what).reset();
    return evidence;
  };
  EXPECT_FALSE(is_fault(without(&MemoryEvidence::free_at_start)));
  EXPECT_FALSE(is_fault(without(&MemoryEvidence::free_now)));
  EXPECT_FALSE(is_fault(without(&MemoryEvidence::was_out_of_memory)));
}

TEST(JudgeKill, NamesTeamAndMemory) {
  MemoryEvidence small_host = against_the_team();
  small_host.free_at_start = 181 * mebibyte;
  EXPECT_EQ(text_of(small_host),
            "the yellow team's process was ended for want of memory when it had taken 900 MiB of "
            "memory and the other team's process 20 MiB; 181 MiB were free when the leg began, and "
            "a leg may "
            "take 2112 MiB");
  MemoryEvidence killed = against_the_team();
  killed.was_out_of_memory = false;
  EXPECT_EQ(text_of(killed),
            "the yellow team's process was killed from outside when it had taken 900 MiB of "
            "memory, and not for want of memory: a cancelled job, or a person");
}

}  // namespace
}  // namespace mirocup::plugins
