// SPDX-License-Identifier: MIT
//
// Catches velocities that a situation leaves uninitialised: laws would judge what was in memory
// before.
#include "core/referee/tick_facts.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <memory>
#include <new>

namespace mirocup::referee {
namespace {

TEST(Situations, RobotsAreAtRestUnlessSaidOtherwise) {
  alignas(TickFacts) std::array<std::byte, sizeof(TickFacts)> memory;
  memory.fill(std::byte{0x3f});
  auto* situation = ::new (memory.data()) TickFacts;
  for (const End end : both_ends) {
    for (int i = 0; i < max_robots_per_team; ++i) {
      EXPECT_EQ(situation->velocity[index_of(end)][i], (Vec2{0.0, 0.0})) << i;
      EXPECT_EQ(situation->commanded[index_of(end)][i], (Vec2{0.0, 0.0})) << i;
    }
  }
  std::destroy_at(situation);
}

}  // namespace
}  // namespace mirocup::referee
