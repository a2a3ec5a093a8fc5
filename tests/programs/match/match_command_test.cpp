// SPDX-License-Identifier: MIT
//
// Runs mirocup match and verify as their users do.
#include "tests/support/program.hpp"

#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>
#include <unistd.h>

namespace mirocup {
namespace {

using namespace test_support;

std::vector<std::string> match(const std::string& blue, const std::string& yellow,
                               const std::vector<std::string>& more = {}) {
  std::vector<std::string> words{program("mirocup"), "match", "--blue", blue,
                                 "--yellow",         yellow,  "--hash"};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

std::string state_hash(const Outcome& outcome) {
  const auto at = outcome.out.find("state hash ");
  return at == std::string::npos ? "none" : outcome.out.substr(at + 11, 16);
}

TEST(MatchCommand, PlaysTheSameLegWithTheSameSeed) {
  const std::vector<std::string> leg{"--half", "20", "--seed", "5"};
  const std::string hash = state_hash(run(match("striker", "chaser", leg)));
  EXPECT_EQ(hash.size(), 16u);
  EXPECT_EQ(state_hash(run(match("striker", "chaser", leg))), hash);
  EXPECT_NE(state_hash(run(match("striker", "chaser", {"--half", "20", "--seed", "6"}))), hash);
  EXPECT_EQ(
      state_hash(run(match("striker", "chaser", {"--half", "20", "--seed", "5", "--trusted"}))),
      hash)
      << "in the server's own process";
}

// MIROCUP_OTHER_BUILDS names other builds of the same sources, debug or clang++: folders, separated
// by ':'.
TEST(MatchCommand, PlaysTheSameLegInEveryBuild) {
  const char* others = std::getenv("MIROCUP_OTHER_BUILDS");
  if (others == nullptr) GTEST_SKIP() << "MIROCUP_OTHER_BUILDS names no other build";
  const std::vector<std::string> leg{"--half", "20", "--seed", "5"};
  const std::string hash = state_hash(run(match("striker", "chaser", leg)));
  std::string folders = others;
  while (!folders.empty()) {
    const std::string folder = folders.substr(0, folders.find(':'));
    folders.erase(0, folder.size() + 1);
    auto words = match("striker", "chaser", leg);
    words[0] = folder + "/mirocup";
    EXPECT_EQ(state_hash(run(words)), hash) << folder;
  }
}

TEST(MatchCommand, PlaysEveryLeagueAndPresetAndTheRecordsVerify) {
  for (const char* league : {"small", "middle", "large"}) {
    for (const char* rules : {"mirosot", "simurosot", "vsss"}) {
      const TemporaryFolder folder;
      const Outcome played = run(match(
          "striker", "keeper",
          {"--league", league, "--rules", rules, "--half", "3", "--record", folder / "leg.json"}));
      EXPECT_EQ(played.exit_code, 0) << league << rules << played.err;
      EXPECT_EQ(read_json(folder / "leg.json")["rules"]["preset"], rules);
      const Outcome verified = run_mirocup({"verify", folder / "leg.json"});
      EXPECT_EQ(verified.exit_code, 0) << league << " " << rules << ": " << verified.out;
    }
  }
}

TEST(MatchCommand, TakesSingleRules) {
  const TemporaryFolder folder;
  run(match("idle", "idle",
            {"--half", "2", "--rule", "stalemate_s=0.5", "--rule", "keeper_hold_s=null", "--record",
             folder / "leg.json"}));
  const auto record = read_json(folder / "leg.json");
  EXPECT_EQ(record["rules"]["stalemate_s"], 0.5);
  EXPECT_TRUE(record["rules"]["keeper_hold_s"].is_null());
  bool called = false;
  for (const auto& d : record["decisions"]) called = called || d["law"] == "stalemate";
  EXPECT_TRUE(called);
}

// Catches two trusted teams in one process that get each other's values, a value of both that wins
// over a team's own, and a record that does not say what was given.
TEST(MatchCommand, GivesEachTeamItsParameters) {
  const std::string tuned = program("teams/tuned.so");
  for (const bool trusted : {false, true}) {
    const TemporaryFolder folder;
    std::vector<std::string> words{"--half",       "2",         "--record", folder / "leg.json",
                                   "--param",      "speed=7",   "--param",  "spede=1",
                                   "--blue-param", "speed=5.25"};
    if (trusted) words.emplace_back("--trusted");
    const Outcome played = expect_exit(0, run(match(tuned, tuned, words)),
                                       "warning: no team asked for the parameter spede\n");
    EXPECT_FALSE(contains(played.err, "parameter speed"));
    const auto teams = read_json(folder / "leg.json")["teams"];
    EXPECT_EQ(teams["blue"]["parameters"],
              (nlohmann::ordered_json{{"spede", 1.0}, {"speed", 5.25}}));
    EXPECT_EQ(teams["yellow"]["parameters"],
              (nlohmann::ordered_json{{"spede", 1.0}, {"speed", 7.0}}));
    std::string log = played.err;
    if (!trusted) {
      log = read_file(folder / "leg.json.blue.log") + read_file(folder / "leg.json.yellow.log");
    }
    EXPECT_TRUE(contains(log, "team 0 turns at 5.25"));
    EXPECT_TRUE(contains(log, "team 1 turns at 7"));
  }
  const Outcome plain = run(match(tuned, "idle", {"--half", "2", "--trusted"}));
  EXPECT_EQ(plain.err, "team 0 turns at 3\n");
}

// Catches a name that moves the cursor or adds a line.
TEST(MatchCommand, EscapesTheNamesThatItPrints) {
  const std::string out =
      run(match("idle", "idle", {"--half", "1", "--blue-name", "a\x1b[31m\nb"})).out;
  EXPECT_EQ(out.rfind("a\\x1b[31m\\x0ab (blue)", 0), 0u) << out;
}

TEST(MatchCommand, NamesTheArgumentThatIsWrong) {
  const auto fails = [](const std::vector<std::string>& words, const std::string& text) {
    const Outcome outcome = run(words);
    EXPECT_EQ(outcome.exit_code, 2) << text;
    EXPECT_TRUE(contains(outcome.err, text));
    EXPECT_EQ(outcome.out, "");
  };
  fails(match("nobody", "idle"), "\"nobody\" is neither a file nor a house team");
  fails(match("idle", "idle", {"--league", "huge"}), "huge");
  fails(match("idle", "idle", {"--speed", "fast"}), "--speed fast");
  fails(match("idle", "idle", {"--rule", "haste=1"}), "/rules/haste");
  fails(match("idle", "idle", {"--stage", "final"}), "final");
  fails(match("idle", "idle", {"--blue-param", "wait"}), "--blue-param wait: KEY=VALUE");
  fails(match("idle", "dds:far", {"--yellow-param", "wait=1"}),
        "give the parameter to mirocup join");
  fails({program("mirocup"), "match", "--blue", "idle"}, "--yellow");
  fails({program("mirocup")}, "After a leg:");
}

// Catches a leg that is played for nothing, because its record has no place.
TEST(CommandLine, TestsTheOutputBeforeItPlays) {
  const Outcome outcome =
      expect_exit(3, run(match("idle", "idle", {"--record", "/no/such/folder/leg.json"})));
  EXPECT_EQ(outcome.out, "") << "nothing was played";
  EXPECT_TRUE(contains(outcome.err, "/no/such/folder"));
}

TEST(MatchCommand, WritesNoRecordWhenItIsInterrupted) {
  const TemporaryFolder folder;
  Running running(match("idle", "idle", {"--watch", "--record", folder / "leg.json"}));
  // It prints the address of its page when both teams are ready.
  ASSERT_TRUE(wait_until([&] { return running.err().find("watch at") != std::string::npos; }))
      << running.err();
  running.signal(SIGINT);
  EXPECT_EQ(running.wait().exit_code, 130);
  EXPECT_EQ(access((folder / "leg.json").c_str(), F_OK), -1);
}

TEST(RefereeCommand, JudgesARecordWithOtherParameters) {
  const TemporaryFolder folder;
  run(match("striker", "chaser", {"--half", "20", "--record", folder / "leg.json"}));
  const std::vector<std::string> referee{program("mirocup"), "referee", "--record",
                                         folder / "leg.json"};
  EXPECT_EQ(run(referee).exit_code, 0) << "with its own it differs nowhere";
  auto shorter = referee;
  for (const char* word : {"--rule", "half_s=10", "--json"}) shorter.push_back(word);
  const Outcome outcome = expect_exit(1, run(shorter));
  const auto answer = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(answer["rules"]["half_s"], 10);
  EXPECT_EQ(answer["differences"][0]["would_be"]["decision"], "HALF_END");
}

TEST(VerifyCommand, TellsTruthFromForgeryAndDamage) {
  const TemporaryFolder folder;
  run(match("striker", "chaser", {"--half", "20", "--record", folder / "leg.json"}));
  const std::string text = read_file(folder / "leg.json");
  const auto verify = [&] { return run_mirocup({"verify", folder / "leg.json", "--json"}); };
  EXPECT_EQ(verify().exit_code, 0);

  auto forged = nlohmann::ordered_json::parse(text);
  forged["result"]["score"]["blue"] = 9;
  write_file(folder / "leg.json", forged.dump());
  Outcome outcome = expect_exit(1, verify());
  EXPECT_EQ(nlohmann::json::parse(outcome.out)["reproduced"], false);

  write_file(folder / "leg.json", text.substr(0, text.size() / 2));
  EXPECT_EQ(verify().exit_code, 4);
  EXPECT_EQ(run_mirocup({"verify", folder / "nothing.json"}).exit_code, 3);
}

// The stronger team wins most of ten legs; those of `planner`, which computes, are short. One build
// is enough, since all play the same legs (PlaysTheSameLegInEveryBuild).
struct Pair {
  const char* stronger;
  const char* weaker;
  const char* half;
  int points;  // legs won minus legs lost
};

class HouseTeams : public testing::TestWithParam<Pair> {};
INSTANTIATE_TEST_SUITE_P(
    Pairs, HouseTeams,
    testing::Values(Pair{"tactician", "navigator", "120", 4}, Pair{"planner", "navigator", "15", 5},
                    Pair{"navigator", "striker", "120", 6}, Pair{"striker", "chaser", "120", 2},
                    Pair{"chaser", "idle", "120", 8}),
    [](const auto& c) { return std::string(c.param.stronger) + "_" + c.param.weaker; });

TEST_P(HouseTeams, AreAsStrongAsTheirNamesSay) {
  const auto& [stronger, weaker, half, points] = GetParam();
  int total = 0;
  for (int seed = 21; seed <= 30; ++seed) {
    const TemporaryFolder folder;
    const bool blue = seed % 2 == 0;
    run(match(blue ? stronger : weaker, blue ? weaker : stronger,
              {"--half", half, "--seed", std::to_string(seed), "--record", folder / "leg.json"}));
    const auto winner = read_json(folder / "leg.json")["result"]["winner"];
    if (winner.is_null()) continue;
    total += (winner == "blue") == blue ? 1 : -1;
  }
  EXPECT_GE(total, points);
}

}  // namespace
}  // namespace mirocup
