// SPDX-License-Identifier: MIT
//
// The comparison runs and prints the figures of the simulator itself, with and without peers. No
// test looks at how fast anything was.
#include "tests/support/program.hpp"

#include <gtest/gtest.h>

namespace mirocup {
namespace {

using test_support::program;
using test_support::run;

// Catches a bench that prints anything else on standard output, that leaves a scene out, and a
// simulator that is far from the yardsticks.
TEST(Bench, PrintsErrorsAndCosts) {
  const test_support::TemporaryFolder folder;
  const auto outcome =
      run({program("mirocup"), "bench", "--quick", "--json", "--rounds", "1", "--engine", "mirocup",
           "--point", "standard", "--plot", folder / "plot.svg"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto report = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(report["schema"], "mirocup/bench/1");
  ASSERT_EQ(report["engines"].size(), 1);
  const auto& own = report["engines"][0];
  EXPECT_EQ(own["point"], "standard");
  for (const char* scene : {"quiet", "game", "game_5", "game_11", "jam", "scrum", "pinch"}) {
    EXPECT_GT(own["cost"][scene]["us_per_tick"], 0.0) << scene;
    EXPECT_LT(own["overlap_m"][scene]["deepest"], 1e-6) << scene;
    EXPECT_FALSE(own["overlap_m"][scene]["ball_is_lost"]) << scene;
  }
  EXPECT_LT(own["error_m"]["free_five_ticks"]["p90"], 1e-12);
  EXPECT_LT(own["error_m"]["crowd_five_ticks"]["p90"], 2e-5);
  for (const auto& shots : own["shots"]) {
    EXPECT_EQ(shots["through_robot"], 0.0);
    EXPECT_EQ(shots["through_plate"], 0.0);
  }
  EXPECT_EQ(test_support::read_file(folder / "plot.svg").rfind("<svg ", 0), 0);
}

TEST(Bench, RefusesWhatItDoesNotKnow) {
  EXPECT_EQ(run({program("mirocup"), "bench", "--fast"}).exit_code, 2);
  EXPECT_EQ(run({program("mirocup"), "bench", "--engine", "none"}).exit_code, 2);
}

}  // namespace
}  // namespace mirocup
