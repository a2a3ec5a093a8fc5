// SPDX-License-Identifier: MIT
//
// Plays legs that start in the middle, as users do.
#include "tests/support/program.hpp"

#include <gtest/gtest.h>

#include <fstream>

namespace mirocup {
namespace {

using namespace test_support;

Outcome play_match(const std::string& blue, const std::string& yellow,
                   const std::vector<std::string>& more) {
  std::vector<std::string> words{program("mirocup"), "match", "--blue", blue, "--yellow", yellow};
  words.insert(words.end(), more.begin(), more.end());
  return run(words);
}

int exit_code(const char* command, const std::string& record) {
  return run_mirocup({command, record}).exit_code;
}

// Catches a state that is lost when a leg is played on: of the laws' counts, of the disturbances,
// of the camera, or of a command on its way.
TEST(PlayOn, WithTheSameTeamsGivesTheSameLeg) {
  const TemporaryFolder folder;
  const std::string leg = folder / "leg.json";
  ASSERT_EQ(play_match("striker", "chaser",
                       {"--half", "20", "--conditions", "camera", "--seed", "3", "--record", leg})
                .exit_code,
            0);
  const auto whole = read_json(leg);
  // The tick of a restart, of a whistle, and some in play.
  std::vector<std::uint32_t> ticks{0, 77, whole["ticks"].get<std::uint32_t>() - 1};
  for (const auto& decision : whole["decisions"]) {
    if (decision["tick"] > 0) ticks.push_back(decision["tick"].get<std::uint32_t>() + 2);
    if (ticks.size() == 5) break;
  }
  const std::string on = folder / "on.json";
  for (const std::uint32_t tick : ticks) {
    ASSERT_EQ(play_match("navigator", "keeper",
                         {"--from", leg, "--tick", std::to_string(tick), "--record", on})
                  .exit_code,
              0);
    EXPECT_EQ(exit_code("verify", on), 0);
    EXPECT_EQ(exit_code("rerun", on), 0) << "other teams, from tick " << tick;
    const auto record = read_json(on);
    EXPECT_EQ(record["from"]["tick"], tick);
    EXPECT_EQ(record["from"]["blue"], "striker");
    EXPECT_EQ(record["from"]["state_hash"], whole["state_hash"]);
  }
  // Teams that remember nothing give the same commands again.
  ASSERT_EQ(play_match("drill:keeper", "drill:crowd", {"--half", "10", "--record", leg}).exit_code,
            0);
  ASSERT_EQ(
      play_match("drill:keeper", "drill:crowd", {"--from", leg, "--tick", "150", "--record", on})
          .exit_code,
      0);
  EXPECT_EQ(read_json(on)["state_hash"], read_json(leg)["state_hash"]);
}

// Catches a situation that the record loses, so that verify, rerun or the page start elsewhere.
TEST(Start, IsHeldByTheRecord) {
  const TemporaryFolder folder;
  std::ofstream(folder / "s.json")
      << R"({"schema": "mirocup/situation/1", "clock": 8, "score": [1, 0],
    "ball": {"position": [0.2, 0.1], "velocity": [0.4, 0]}, "phase": "SECOND_HALF",
    "blue": [{}, {"pose": [0.1, 0, 0.5], "twist": [0.5, 0, 0]}, {"broken": true}]})";
  const std::string leg = folder / "leg.json";
  ASSERT_EQ(play_match("striker", "keeper",
                       {"--half", "12", "--start", folder / "s.json", "--record", leg})
                .exit_code,
            0);
  const auto record = read_json(leg);
  EXPECT_EQ(record["situation"]["score"], (nlohmann::ordered_json{1, 0}));
  EXPECT_GE(record["result"]["score"]["blue"], 1);
  EXPECT_LT(record["ticks"], 400);
  EXPECT_EQ(exit_code("verify", leg), 0);
  EXPECT_EQ(exit_code("rerun", leg), 0);
  EXPECT_EQ(run_mirocup({"replay", leg, "-o", folder / "leg.html"}).exit_code, 0);
}

TEST(Start, RefusesWhatCannotBePlayed) {
  const TemporaryFolder folder;
  std::ofstream(folder / "s.json") << R"({"schema": "mirocup/situation/1", "league": "middle"})";
  EXPECT_EQ(play_match("idle", "idle", {"--start", folder / "none.json"}).exit_code, 3);
  expect_exit(2, play_match("idle", "idle", {"--start", folder / "s.json", "--league", "small"}),
              "of the middle league");
  ASSERT_EQ(play_match("idle", "idle", {"--half", "1", "--record", folder / "leg.json"}).exit_code,
            0);
  expect_exit(2, play_match("idle", "idle", {"--from", folder / "leg.json", "--tick", "9999"}),
              "--tick is at most");
  EXPECT_EQ(play_match("idle", "idle", {"--from", folder / "leg.json"}).exit_code, 2);
  EXPECT_EQ(
      play_match("idle", "idle", {"--from", folder / "leg.json", "--tick", "1", "--seed", "2"})
          .exit_code,
      2);
}

}  // namespace
}  // namespace mirocup
