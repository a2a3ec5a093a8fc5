// SPDX-License-Identifier: MIT
//
// What a host does beside starting a league: takes entries, rules, pauses, uses other machines.
// Catches an entry that plays without having passed, a decision that is lost or not told, a leg
// that is played twice because another process had played it.
#include "tests/programs/league/league_command.hpp"

#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>
#include <memory>
#include <regex>
#include <unistd.h>

namespace mirocup {
namespace {

using namespace test_support;

TEST(Entries, AreStoredAndCheckedAndTheLastAcceptedOnePlays) {
  const TemporaryFolder temporary;
  const std::string folder = temporary / "l";
  init_league(folder, {});
  Outcome outcome = expect_exit(0, run(league("submit", folder, {"alpha", house("chaser")})));
  EXPECT_EQ(outcome.out, "alpha: entry 1 was accepted\n");

  const std::string bad = temporary / "bad.so";
  write_file(bad, read_file(house("chaser")).substr(0, 3000));
  outcome = run(league("submit", folder, {"alpha", bad}));
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ(outcome.out.rfind("alpha: entry 2 was not accepted: complete: ", 0), 0u) << outcome.out;
  EXPECT_TRUE(contains(outcome.out, "; entry 1 plays on\n"));
  EXPECT_EQ(read_file(folder + "/entries/alpha/2/strategy.so"), read_file(bad));
  EXPECT_EQ(read_json(folder + "/entries/alpha/2/verdict.json")["accepted"], false);

  // A team that is not in the league yet joins with its first entry that passes.
  EXPECT_EQ(run(league("submit", folder, {"beta", bad})).exit_code, 1);
  EXPECT_EQ(read_json(folder + "/league.json")["teams"].size(), 1u);
  EXPECT_EQ(run(league("submit", folder, {"beta", house("keeper")})).out,
            "beta: entry 2 was accepted\n");
  EXPECT_EQ(run(league("submit", folder, {"../beta", bad})).exit_code, 2);

  // The host sees who needs help without reading each verdict.
  EXPECT_EQ(run(league("submit", folder, {"still", house("idle")})).exit_code, 0);
  EXPECT_TRUE(contains(run(league("status", folder, {"--entries"})).out,
                       "\n    it never turned a wheel in play"));

  ASSERT_EQ(run(league("start", folder)).exit_code, 0);
  for (const auto& line : journal_of(folder)) {
    if (line["kind"] == "entry") {
      EXPECT_EQ(line["entry"], line["team"] == "beta" ? 2 : 1);
    }
  }
  outcome = run(league("submit", folder, {"alpha", house("striker")}));
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_TRUE(contains(outcome.out, "entries are frozen"));
}

TEST(Rulings, ArePublishedAndCount) {
  const std::regex utc_time(R"(\d{4}-\d\d-\d\dT\d\d:\d\d:\d\dZ)");
  const TemporaryFolder temporary;
  const std::string folder = temporary / "l";
  init_league(folder, {"a=house:chaser", "b=house:keeper", "c=house:idle"});
  ASSERT_EQ(run(league("start", folder)).exit_code, 0);
  const std::string record = read_file(folder + "/records/r1-f1-1-1.json");

  EXPECT_EQ(run(league("award", folder, {"r1-f1", "nobody", "--reason", "x"})).exit_code, 2);
  EXPECT_EQ(run(league("award", folder, {"r9-f9", "a", "--reason", "x"})).exit_code, 2);
  EXPECT_EQ(run(league("award", folder, {"r1-f1", "a"})).exit_code, 2) << "a reason is needed";
  const auto fixture = [&](const std::string& id, const std::string& side) {
    for (const auto& line : journal_of(folder)) {
      if (line["kind"] == "leg" && line["fixture"] == id) return line[side].get<std::string>();
    }
    return std::string();
  };
  const std::string away = fixture("r1-f1", "away");
  std::string before;
  for (const auto& line : journal_of(folder)) {
    if (line["kind"] == "leg" && line["fixture"] == "r1-f1" && line["leg"] == 2)
      before = line["score"]["home"].dump() + ":" + line["score"]["away"].dump();
  }
  EXPECT_EQ(
      run(league("award", folder,
                 {"r1-f1", away, "--leg", "2", "--reason", "<b>glue</b>", "--by", "Host"}))
          .out,
      "r1-f1 leg 2, " + fixture("r1-f1", "home") + " – " + away + ": 0:10 (was " + before + ")\n");
  EXPECT_EQ(run(league("rule", folder, {"r2-f1", "--leg", "1", "--score", "7:6", "--reason", "x"}))
                .exit_code,
            0);
  EXPECT_EQ(run(league("rule", folder, {"r2-f1", "--score", "7", "--reason", "x"})).exit_code, 2);
  EXPECT_EQ(
      run(league("void", folder, {"r1-f1", "--leg", "1", "--reason", "cable fault"})).exit_code, 0);
  EXPECT_EQ(run(league("void", folder, {"r1-f1", "--leg", "1", "--reason", "x"})).exit_code, 2)
      << "it is void already";

  EXPECT_EQ(run(league("status", folder)).exit_code, 1) << "a leg is to be played";
  ASSERT_EQ(run(league("start", folder)).exit_code, 0);
  EXPECT_EQ(read_file(folder + "/records/r1-f1-1-1.json"), record) << "what was void is evidence";
  // With the same seed, the same libraries would play the same leg again.
  const auto again = read_json(folder + "/records/r1-f1-1-2.json");
  EXPECT_NE(again["seed"], nlohmann::ordered_json::parse(record)["seed"]);
  EXPECT_NE(again["state_hash"], nlohmann::ordered_json::parse(record)["state_hash"]);
  EXPECT_EQ(run(league("verify", folder)).exit_code, 0);
  EXPECT_EQ(
      run(league("void", folder, {"r2-f1", "--leg", "2", "--same-seed", "--reason", "a power cut"}))
          .exit_code,
      0);
  ASSERT_EQ(run(league("start", folder)).exit_code, 0);
  EXPECT_EQ(read_json(folder + "/records/r2-f1-2-2.json")["state_hash"],
            read_json(folder + "/records/r2-f1-2-1.json")["state_hash"]);
  const std::string page = read_file(folder + "/site/index.html");
  EXPECT_TRUE(contains(page, "ruling: &lt;b&gt;glue&lt;/b&gt; (Host)"));
  EXPECT_TRUE(contains(page, "what was played before is void: cable fault"));
  EXPECT_TRUE(contains(page, ">7:6<"));
  const auto decisions = read_json(folder + "/site/decisions.json")["decisions"];
  ASSERT_EQ(decisions.size(), 4u);
  EXPECT_EQ(decisions[0]["by"], "Host");
  EXPECT_TRUE(decisions[1]["by"].is_null());
  EXPECT_EQ(decisions[2]["why"], "cable fault");
  for (const auto& decision : decisions) {
    EXPECT_TRUE(std::regex_match(decision["at"].get<std::string>(), utc_time)) << decision;
  }
  for (const auto& line : journal_of(folder)) {
    EXPECT_TRUE(std::regex_match(line["at"].get<std::string>(), utc_time)) << line;
  }

  EXPECT_EQ(
      run(league("withdraw", folder, {"c", "--reason", "left", "--results", "annul"})).exit_code,
      0);
  ASSERT_EQ(run(league("publish", folder)).exit_code, 0);
  const auto later = read_json(folder + "/site/decisions.json")["decisions"];
  ASSERT_EQ(later.size(), 5u);
  EXPECT_EQ(later[4]["kind"], "withdraw");
  const auto site = site_of(folder);
  ASSERT_EQ(run(league("publish", folder)).exit_code, 0);
  EXPECT_TRUE(site == site_of(folder)) << "the same journal, the same bytes";
  const auto status = nlohmann::json::parse(run(league("status", folder, {"--json"})).out);
  EXPECT_EQ(status["legs"], 2);
  EXPECT_EQ(status["played"], 2);
}

class EveryFormat : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Kinds, EveryFormat, testing::Values("knockout", "swiss", "ladder"));

TEST_P(EveryFormat, HasTheSamePagesWhetherShardsOrOneProgramPlayedIt) {
  const TemporaryFolder temporary;
  const std::string direct = temporary / "direct/l";
  const std::string shards_folder = temporary / "shards/l";
  const std::vector<std::string> teams{"a=house:chaser", "b=house:keeper", "c=house:striker",
                                       "d=house:idle", "e=house:chaser"};
  init_league(direct, teams, "1", GetParam());
  init_league(shards_folder, teams, "1", GetParam());
  ASSERT_EQ(run(league("start", direct, {"--jobs", "2"})).exit_code, 0);
  // Plays shards as GNU parallel or a cluster would; some rounds are known only after others.
  for (int round = 0; round < 10; ++round) {
    std::istringstream plan(run(league("plan", shards_folder)).out);
    std::vector<std::unique_ptr<Running>> shards;
    for (std::string id; plan >> id;) {
      const std::vector<std::string> command{program("mirocup-league"), "run-shard", shards_folder,
                                             id};
      shards.push_back(std::make_unique<Running>(command));
    }
    for (const auto& shard : shards) EXPECT_EQ(shard->wait().exit_code, 0);
    if (shards.empty()) break;
  }
  ASSERT_EQ(run(league("start", shards_folder)).exit_code, 0);
  expect_same_site(shards_folder, direct);
}

TEST(Shards, ArePlayedOnce) {
  const TemporaryFolder temporary;
  const std::string folder = temporary / "l";
  init_league(folder, {"a=house:chaser", "b=house:keeper"});
  EXPECT_EQ(run({program("mirocup-league"), "run-shard", folder, "r1-f1"}).exit_code, 2)
      << "it has not started";
  EXPECT_EQ(run(league("plan", folder)).out, "r1-f1\n");
  EXPECT_EQ(run({program("mirocup-league"), "run-shard", folder, "r1-f1"}).exit_code, 0);
  const std::string record = folder + "/records/r1-f1-1-1.json";
  const auto written = std::filesystem::last_write_time(record);
  EXPECT_EQ(run({program("mirocup-league"), "run-shard", folder, "r1-f1"}).exit_code, 0);
  EXPECT_EQ(count_kind(folder, "leg"), 0) << "a shard only writes records";
  ASSERT_EQ(run(league("start", folder)).exit_code, 0);
  EXPECT_EQ(std::filesystem::last_write_time(record), written);
  EXPECT_EQ(count_kind(folder, "leg"), 2);
}

TEST(Interrupts, LetLegsComeToTheirEndTheFirstTime) {
  const TemporaryFolder temporary;
  const std::string folder = temporary / "l";
  init_league(folder, {"a=house:chaser", "b=house:keeper", "c=house:striker"}, "60");
  Running running(league("start", folder, {"--jobs", "1"}));
  const std::string records = folder + "/records";
  ASSERT_TRUE(wait_until_it_plays(folder));
  EXPECT_EQ(run(league("start", folder)).exit_code, 3) << "one at a time";
  EXPECT_EQ(run(league("stop", folder)).exit_code, 0);
  EXPECT_EQ(running.wait().exit_code, 130);
  int played = 0;
  for (const auto& file : std::filesystem::directory_iterator(records))
    played += file.path().extension() == ".json" ? 1 : 0;
  EXPECT_GT(played, 0);
  EXPECT_LT(played, 6);
  EXPECT_EQ(count_kind(folder, "leg"), played) << "nothing that was played is lost";
  EXPECT_EQ(run(league("stop", folder)).exit_code, 1) << "nobody plays it";
}

}  // namespace
}  // namespace mirocup
