// SPDX-License-Identifier: MIT
//
// Runs mirocup stats and mirocup coach as their users do.
#include "tests/support/program.hpp"

#include <gtest/gtest.h>

#include <filesystem>

namespace mirocup {
namespace {

using Json = nlohmann::ordered_json;
using namespace test_support;

Outcome stats(const std::vector<std::string>& arguments) {
  std::vector<std::string> words{program("mirocup"), "stats"};
  words.insert(words.end(), arguments.begin(), arguments.end());
  return run(words);
}

class StatsCommand : public testing::Test {
 protected:
  void SetUp() override {
    for (const char* seed : {"2", "3"}) {
      records_.push_back(folder_ / (std::string("leg") + seed + ".json"));
      ASSERT_EQ(run_mirocup({"match", "--blue", "striker", "--yellow", "chaser", "--half", "40",
                             "--seed", seed, "--record", records_.back(), "--trusted"})
                    .exit_code,
                0);
    }
  }

  TemporaryFolder folder_;
  std::vector<std::string> records_;
};

// Catches a goal that is missing, and statistics that do not follow from the record.
TEST_F(StatsCommand, TellsTheGoalsOfTheRecord) {
  const Outcome printed = expect_exit(0, stats({records_[0], records_[1], "--json"}));
  const Json json = Json::parse(printed.out);
  EXPECT_EQ(json["schema"], "mirocup/statistics/1");
  ASSERT_EQ(json["legs"].size(), 2u);
  ASSERT_EQ(json["teams"].size(), 2u);
  int goals = 0;
  for (std::size_t i = 0; i < 2; ++i) {
    const auto record = read_json(records_[i]);
    EXPECT_EQ(json["legs"][i]["score"], record["result"]["played"]);
    EXPECT_EQ(json["legs"][i]["teams"]["blue"]["goals"], record["result"]["played"]["blue"]);
    std::vector<int> ticks;
    for (const Json& goal : json["legs"][i]["goals"]) ticks.push_back(goal["tick"].get<int>());
    std::vector<int> recorded;
    for (const auto& call : record["decisions"]) {
      if (call["decision"] == "GOAL") recorded.push_back(call["tick"].get<int>());
    }
    EXPECT_EQ(ticks, recorded);
    goals += static_cast<int>(ticks.size());
  }
  EXPECT_EQ(
      json["teams"][0]["own"]["goals"].get<int>() + json["teams"][1]["own"]["goals"].get<int>(),
      goals);
}

// Catches a filter that leaves nothing out, or the legs of the team itself.
TEST_F(StatsCommand, TellsOfOneTeam) {
  const Outcome one = expect_exit(0, stats({records_[0], "--goals", "--team", "chaser"}));
  EXPECT_EQ(one.out.rfind("chaser, 1 leg: ", 0), 0u);
  EXPECT_FALSE(contains(one.out, "striker, 1 leg: "));
  EXPECT_EQ(stats({records_[0], "--team", "keeper"}).exit_code, 2);
  EXPECT_EQ(Json::parse(stats({records_[0], "--json", "--team", "striker"}).out)["legs"].size(),
            1u);
}

// Catches numbers that are printed although a record is damaged, and a wrong exit code.
TEST_F(StatsCommand, ReportsDamageMissingFilesAndWrongUsage) {
  std::string text = read_file(records_[1]);
  text[text.size() / 2] ^= 1;
  write_file(records_[1], text);
  const Outcome damaged = expect_exit(4, stats({records_[0], records_[1], "--csv"}));
  EXPECT_EQ(damaged.out, "");
  EXPECT_TRUE(contains(damaged.err, "leg3.json"));
  EXPECT_EQ(stats({folder_ / "nothing.json"}).exit_code, 3);
  EXPECT_EQ(stats({records_[0], "--csv", "--json"}).exit_code, 2);
  EXPECT_EQ(stats({}).exit_code, 2);
  const Outcome both = stats({records_[0], folder_ / ""});
  EXPECT_EQ(both.exit_code, 2) << "a folder and a record";
  EXPECT_EQ(stats({folder_ / ""}).exit_code, 2) << "a folder without a league";
}

// Catches a goal that is left out, an answer of the search that another run does not give, a team
// that decides otherwise than in its record, and a library that plays here though nobody trusts it.
TEST_F(StatsCommand, CoachSaysUntilWhenEachGoalCouldBePrevented) {
  const std::string record = folder_ / "lost.json";
  run_mirocup({"match", "--blue", "striker", "--yellow", "idle", "--half", "12", "--seed", "3",
               "--record", record, "--trusted"});
  const Outcome twice = expect_exit(0, run_mirocup({"coach", "--all", record, record, "--team",
                                                    "idle", "--goal", "1", "--json"}));
  const Json goals = Json::parse(twice.out)["goals"];
  ASSERT_EQ(goals.size(), 2u);
  EXPECT_EQ(goals[0], goals[1]);
  for (const Json& goal : goals) {
    EXPECT_TRUE(goal["decides"]["blue"] && goal["decides"]["yellow"]) << goal;
    EXPECT_LE(goal["hopeless"]["tick"], goal["tick"]);
    if (goal["prevention"].is_null()) continue;
    EXPECT_LT(goal["prevention"]["tick"], goal["hopeless"]["tick"]);
    EXPECT_GE(goal["prevention"]["without_goal"], 80);
  }
  EXPECT_EQ(run_mirocup({"coach", record, "--team", "yellow", "--goal", "3"}).exit_code, 2);
  const std::string library = folder_ / "mine.so";
  std::filesystem::copy(program("house/chaser.so"), library);
  const Outcome distrusted =
      run_mirocup({"coach", record, "--team", "yellow", "--substitute", library});
  EXPECT_TRUE(contains(distrusted.err, "give --trusted"));
}

}  // namespace
}  // namespace mirocup
