// SPDX-License-Identifier: MIT
//
// The comparison runs and prints the figures of the simulator itself, with and without peers. No
// test looks at how fast anything was.
#include "tests/support/program.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <string>

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
  EXPECT_GE(own["error_m"]["crowd_five_ticks"]["p99"], own["error_m"]["crowd_five_ticks"]["p90"]);
  EXPECT_LT(own["error_m"]["crowd_five_ticks"]["p99"], 1e-3);
  for (const auto& shots : own["shots"]) {
    EXPECT_EQ(shots["through_robot"], 0.0);
    EXPECT_EQ(shots["through_plate"], 0.0);
  }
  const std::string plot = test_support::read_file(folder / "plot.svg");
  EXPECT_EQ(plot.rfind("<svg ", 0), 0);
  EXPECT_NE(plot.find("crowded ticks (p99), mm"), std::string::npos);
}

TEST(Bench, RefusesWhatItDoesNotKnow) {
  EXPECT_EQ(run({program("mirocup"), "bench", "--fast"}).exit_code, 2);
  EXPECT_EQ(run({program("mirocup"), "bench", "--engine", "none"}).exit_code, 2);
}

// Catches a validation that forgets the engine, one that claims an engine it does not have, and an
// engine's greeting in the JSON.
TEST(Bench, ValidatesAgainstAnotherEngineOrSaysThatItIsNotBuilt) {
  const test_support::TemporaryFolder folder;
  std::string text =
      R"({"schema": "mirocup/recording/1", "period": 0.02, "robots": 0, "pitch": null})";
  for (int i = 0; i < 150; ++i) {
    const double t = 0.02 * i;
    const double noise = 0.001 * (i * 7 % 5 - 2);  // m; without any, no start is good enough
    text += "\n{\"t\": " + std::to_string(t) + ", \"ball\": [" +
            std::to_string(-0.5 + 0.4 * t - 0.05 * t * t + noise) +
            ", 0.1], \"blue\": [], \"yellow\": []}";
  }
  std::ofstream(folder / "roll.jsonl") << text << "\n";
  for (const std::string engine : {"box2d", "chipmunk", "ode"}) {
    const auto outcome =
        run({program("mirocup"), "validate", "--json", "--against", engine, folder / "roll.jsonl"});
    if (outcome.exit_code == 3) {
      EXPECT_NE(outcome.err.find("is built without it"), std::string::npos) << outcome.err;
      continue;
    }
    EXPECT_LT(outcome.exit_code, 2) << outcome.err;
    const auto result = nlohmann::json::parse(outcome.out, nullptr, false);
    ASSERT_FALSE(result.is_discarded()) << outcome.out;
    EXPECT_EQ(result["peer"], engine);
    EXPECT_TRUE(result["kinds"]["free_roll"][0].contains("peer")) << outcome.out;
  }
  EXPECT_EQ(
      run({program("mirocup"), "validate", "--against", "none", folder / "roll.jsonl"}).exit_code,
      2);
}

}  // namespace
}  // namespace mirocup
