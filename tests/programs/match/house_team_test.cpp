// SPDX-License-Identifier: MIT
//
// Puts the house teams into situations in which they once did the wrong thing.
#include "tests/support/program.hpp"

#include <gtest/gtest.h>

#include <fstream>

namespace mirocup {
namespace {

using namespace test_support;

// A goal against blue or yellow falls while robot 2 is nearest to the ball. Yellow's situation is
// blue's, turned by 180 degrees.
constexpr const char* goals_fall[2] = {
    R"({"schema": "mirocup/situation/1", "ball": {"position": [-0.6, 0], "velocity": [-1.5, 0]},
        "blue": [{"pose": [-0.4, -0.5, 0]}, {"pose": [0.4, 0.5, 0]}, {"pose": [-0.5, 0, 0]}]})",
    R"({"schema": "mirocup/situation/1", "ball": {"position": [0.6, 0], "velocity": [1.5, 0]},
        "yellow": [{"pose": [0.4, 0.5, 0]}, {"pose": [-0.4, -0.5, 0]}, {"pose": [0.5, 0, 0]}]})"};

// Catches a team in which a mate who attacked before the kick-off runs at the ball, into which the
// kicker then pushes it forwards.
TEST(HouseTeam, TakesItsKickOffBackwards) {
  const TemporaryFolder folder;
  for (const bool is_blue : {true, false}) {
    std::ofstream(folder / "s.json") << goals_fall[is_blue ? 0 : 1];
    for (const std::string team : {"chaser", "striker", "navigator", "tactician"}) {
      for (const std::string seed : {"1", "2"}) {
        const auto leg =
            run_mirocup({"match", is_blue ? "--blue" : "--yellow", team,
                         is_blue ? "--yellow" : "--blue", "idle", "--half", "3", "--seed", seed,
                         "--start", folder / "s.json", "--record", folder / "leg.json"});
        ASSERT_EQ(leg.exit_code, 0) << leg.err;
        const auto decisions = read_json(folder / "leg.json")["decisions"];
        ASSERT_EQ(decisions[0]["decision"], "GOAL") << decisions.dump();
        for (const auto& one : decisions) {
          EXPECT_NE(one["decision"], "KICK_OFF_VIOLATION") << team << ": " << one["reason"];
        }
      }
    }
  }
}

}  // namespace
}  // namespace mirocup
