// SPDX-License-Identifier: MIT
//
// Whose fault a process is that the kernel ended. Catches a host's shortage that becomes a team's
// loss.
#include "plugins/host/memory_witness.hpp"

#include "system/memory.hpp"

#include <gtest/gtest.h>

#include <optional>

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

// Returns the same evidence but for one number.
template <class Number, class Value>
MemoryEvidence with(Number MemoryEvidence::*what, Value value) {
  MemoryEvidence evidence = against_the_team();
  evidence.*what = value;
  return evidence;
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
  using E = MemoryEvidence;
  EXPECT_FALSE(is_fault(with(&E::free_at_start, system::memory_of_a_leg - 1)));
  EXPECT_FALSE(is_fault(with(&E::other_peak, against_the_team().own_peak)));
  EXPECT_FALSE(is_fault(with(&E::own_peak, 100 * mebibyte))) << "the memory went elsewhere";
  EXPECT_FALSE(is_fault(with(&E::free_now, 900 * mebibyte))) << "another program has taken it";
  EXPECT_FALSE(is_fault(with(&E::was_out_of_memory, false))) << "a person has killed it";
  EXPECT_FALSE(is_fault(with(&E::free_at_start, std::nullopt)));
  EXPECT_FALSE(is_fault(with(&E::free_now, std::nullopt)));
  EXPECT_FALSE(is_fault(with(&E::was_out_of_memory, std::nullopt)));
}

TEST(JudgeKill, NamesTeamAndMemory) {
  const std::string small_host = text_of(with(&MemoryEvidence::free_at_start, 181 * mebibyte));
  EXPECT_NE(small_host.find("the yellow team's process was ended for want of memory"),
            std::string::npos);
  EXPECT_NE(small_host.find("; 181 MiB were free when the leg began"), std::string::npos);
  EXPECT_EQ(text_of(with(&MemoryEvidence::was_out_of_memory, false)),
            "the yellow team's process was killed from outside when it had taken 900 MiB of "
            "memory, and not for want of memory: a cancelled job, or a person");
}

}  // namespace
}  // namespace mirocup::plugins
