// SPDX-License-Identifier: MIT
//
// Catches a league that starts without a word on a machine that is too small for it.
#include "tournaments/play/runner.hpp"

#include "system/memory.hpp"

#include <gtest/gtest.h>

namespace mirocup::league {
namespace {

constexpr std::size_t leg = system::memory_of_a_leg;

TEST(MemoryWarning, IsGivenWhereLegsAtOnceMayTakeMoreThanThereIs) {
  EXPECT_EQ(memory_warning(std::nullopt, 1000), "") << "the kernel tells nothing";
  EXPECT_EQ(memory_warning(4 * leg, 4), "");
  EXPECT_EQ(
      memory_warning(4 * leg - 1, 4),
      "warning: 8447 MiB of memory are free, and 4 legs at once may take 8448 MiB; a leg "
      "that runs out of memory is void and played again; with --jobs 3 the memory always suffices");
  EXPECT_EQ(memory_warning(std::size_t{200} << 20, 1),
            "warning: 200 MiB of memory are free, and 1 leg may take 2112 MiB; a leg that runs out "
            "of memory is void and played again");
}

}  // namespace
}  // namespace mirocup::league
