// SPDX-License-Identifier: MIT
#include "core/referee/situation.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <memory>
#include <new>

namespace mirocup::referee {
namespace {

// Catches velocities that are left as the memory was: a law then judges robots that were never set.
TEST(Situation, RobotsStandStillUntilTheyAreSet) {
  alignas(Situation) std::array<std::byte, sizeof(Situation)> memory;
  std::memset(memory.data(), 0x7f, memory.size());
  auto* situation = new (memory.data()) Situation;
  for (const End end : both_ends) {
    for (const Vec2& v : situation->velocity[index_of(end)]) EXPECT_EQ(v, (Vec2{0.0, 0.0}));
    for (const Vec2& v : situation->commanded[index_of(end)]) EXPECT_EQ(v, (Vec2{0.0, 0.0}));
  }
  std::destroy_at(situation);
}

}  // namespace
}  // namespace mirocup::referee
