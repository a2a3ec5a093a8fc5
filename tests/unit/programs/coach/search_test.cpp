// SPDX-License-Identifier: MIT
//
// Catches a search that misses the last moment, or a later one behind a gap, one that asks about
// every tick, and a test that errs more often than it says or plays on about what is clear.
#include "programs/coach/search.hpp"

#include "core/base/random.hpp"
#include "record/wilson.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <tuple>

namespace mirocup::coach {
namespace {

TEST(CoachSearch, FindsEachLastMoment) {
  for (std::uint32_t last = 100; last < 190; ++last) {
    int asked = 0;
    const auto found = last_yes(100, 190, 9, [&](std::uint32_t tick) {
      ++asked;
      return tick <= last;
    });
    EXPECT_EQ(found, last);
    EXPECT_LE(asked, 10 + 4 + 9);
  }
  const auto never = [](std::uint32_t) { return false; };
  EXPECT_EQ(last_yes(100, 190, 9, never), std::nullopt);
  EXPECT_EQ(last_yes(100, 100, 9, never), std::nullopt);
  // A yes that comes again less than a stride after the no.
  EXPECT_EQ(last_yes(0, 90, 9, [](std::uint32_t t) { return t <= 40 || t == 46; }), 46u);
}

// Returns the share of tests that say yes of a chance, and counts their futures.
double yes_share(Question question, double chance, int& futures) {
  constexpr int tests = 2000;
  Random random(7);
  int yes = 0;
  for (int i = 0; i < tests; ++i) {
    Share share;
    while (!answer_of(question, share)) share.add(random.uniform() < chance);
    yes += *answer_of(question, share) ? 1 : 0;
    futures = std::max(futures, share.futures);
  }
  return static_cast<double>(yes) / tests;
}

TEST(CoachSearch, TestErrsAsSeldomAsItSays) {
  int futures = 0;
  for (const auto& [question, low, high] :
       {std::tuple(Question::prevention, 0.7, 0.9), std::tuple(Question::hope, 0.1, 0.3)}) {
    EXPECT_LE(yes_share(question, low, futures), 0.09);
    EXPECT_GE(yes_share(question, high, futures), 0.92);
  }
  EXPECT_EQ(futures, 50);
  int clear = 0;
  EXPECT_EQ(yes_share(Question::prevention, 0.0, clear), 0.0);
  EXPECT_EQ(clear, 3);
  EXPECT_EQ(yes_share(Question::prevention, 1.0, clear), 1.0);
  EXPECT_EQ(clear, 12);
  const record::Interval of_83 = record::wilson_interval(0.83, 100);
  EXPECT_NEAR(of_83.low, 0.745, 0.001);  // Wilson, as R's binom.confint() has it
  EXPECT_NEAR(of_83.high, 0.891, 0.001);
}

}  // namespace
}  // namespace mirocup::coach
