// SPDX-License-Identifier: MIT
//
// Catches a changed generator (records say "mirocup-1"), a biased draw, a seed that does not
// matter.
#include "core/base/random.hpp"

#include <gtest/gtest.h>

#include <array>

namespace mirocup {
namespace {

TEST(Random, ASeedAlwaysGivesTheSameNumbers) {
  Random random(42);
  EXPECT_EQ(random.next(), 1546998764402558742ULL);
  EXPECT_EQ(random.next(), 6990951692964543102ULL);
  EXPECT_EQ(random.next(), 12544586762248559009ULL);
}

TEST(Random, SeedsWithOneDifferentBitGiveUnrelatedNumbers) {
  Random a(6);
  Random b(7);
  int equal_bits = 0;
  for (int i = 0; i < 1000; ++i) equal_bits += 64 - __builtin_popcountll(a.next() ^ b.next());
  EXPECT_NEAR(equal_bits, 32000, 600);
}

TEST(Random, EveryNumberBelowABoundIsEquallyLikely) {
  Random random(3);
  std::array<int, 6> seen{};
  for (int i = 0; i < 60000; ++i) ++seen[random.below(6)];
  for (const int count : seen) EXPECT_NEAR(count, 10000, 400);
}

TEST(Random, UniformStaysInItsRange) {
  Random random(4);
  double sum = 0.0;
  for (int i = 0; i < 100000; ++i) {
    const double x = random.uniform(-2.0, 3.0);
    ASSERT_GE(x, -2.0);
    ASSERT_LT(x, 3.0);
    sum += x;
  }
  EXPECT_NEAR(sum / 100000, 0.5, 0.02);
}

}  // namespace
}  // namespace mirocup
