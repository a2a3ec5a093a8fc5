// SPDX-License-Identifier: MIT
//
// Whole legs of programs that speak FIRASim's protocol: our example in Python, and a client in C++
// with libprotobuf.
#include "tests/support/program.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <unistd.h>

namespace mirocup {
namespace {

using namespace test_support;
using Json = nlohmann::ordered_json;

// Ports of its own for each test process, because tests run at the same time.
std::string instance() {
  return std::to_string(2000 + getpid() % 7000);
}

std::vector<std::string> python_team(const std::string& colour,
                                     std::vector<std::string> more = {}) {
  std::vector<std::string> command{
      "/usr/bin/env", "PYTHONDONTWRITEBYTECODE=1",
      "python3",      MIROCUP_SOURCE_FOLDER "/examples/firasim/chaser.py",
      colour,         "--instance",
      instance()};
  command.insert(command.end(), more.begin(), more.end());
  return command;
}

Outcome match(const std::string& blue, const std::string& yellow, const std::string& record,
              const std::vector<std::string>& more) {
  std::vector<std::string> command{
      program("mirocup"), "match", "--blue",   blue,   "--yellow",           yellow,
      "--rules",          "vsss",  "--record", record, "--firasim-instance", instance()};
  command.insert(command.end(), more.begin(), more.end());
  return run(command);
}

// Catches commands of one colour that drive the other, a second half with the wrong frame, and an
// answer that belongs to another tick: then the same seed has different legs.
TEST(Firasim, InLockstepTheSameSeedIsTheSameLeg) {
  for (const std::string colour : {"blue", "yellow"}) {
    std::string hash;
    for (int i = 0; i < 2; ++i) {
      const TemporaryFolder folder;
      Running team(python_team(colour));
      const bool is_blue = colour == "blue";
      const Outcome played =
          match(is_blue ? "firasim:py" : "idle", is_blue ? "idle" : "firasim:py",
                folder / "leg.json", {"--lockstep", "--half", "15", "--rule", "ready_s=0.33"});
      ASSERT_EQ(played.exit_code, 0) << played.err;
      EXPECT_EQ(team.wait().exit_code, 0);
      const Json record = read_json(folder / "leg.json");
      EXPECT_EQ(record["result"]["end"], "full_time") << record["result"].dump();
      EXPECT_EQ(record["teams"][colour]["kind"], "firasim");
      EXPECT_EQ(record["network"][colour]["in_step"], record["ticks"]);
      // It asks for places in the field's own half: in both colours, at every restart.
      EXPECT_GE(record["network"][colour]["datagrams"]["placements"], 2);
      EXPECT_GT(record["result"]["score"][colour], 0) << "its robots go the wrong way";
      EXPECT_TRUE(i == 0 || record["state_hash"] == hash);
      hash = record["state_hash"];
      EXPECT_EQ(run({program("mirocup"), "verify", folder / "leg.json"}).exit_code, 0);
    }
  }
}

// Catches an encoding that only our own decoder reads, and one datagram for each robot taken for a
// whole answer.
TEST(Firasim, ClientsWithProtobufPlayEachOther) {
  if (!std::filesystem::exists(program("firasim_client"))) GTEST_SKIP() << "built without protobuf";
  const TemporaryFolder folder;
  Running blue({program("firasim_client"), "blue", instance()});
  Running yellow({program("firasim_client"), "yellow", instance()});
  const Outcome played =
      match("firasim:one", "firasim:two", folder / "leg.json", {"--lockstep", "--half", "8"});
  ASSERT_EQ(played.exit_code, 0) << played.err;
  for (Running* client : {&blue, &yellow}) {
    const Outcome ended = client->wait();
    EXPECT_EQ(ended.exit_code, 0) << ended.err;
  }
  const Json record = read_json(folder / "leg.json");
  EXPECT_EQ(record["result"]["end"], "full_time") << record["result"].dump();
  EXPECT_EQ(record["isolation"], "network");
  for (const char* colour : {"blue", "yellow"}) {
    EXPECT_EQ(record["network"][colour]["in_step"], record["ticks"]);
    EXPECT_EQ(record["network"][colour]["processes"], 1);
  }
  EXPECT_EQ(run({program("mirocup"), "verify", folder / "leg.json"}).exit_code, 0);
}

// Catches a match that waits for a team by its own clock although real time passes.
TEST(Firasim, PlaysByTheClock) {
  const TemporaryFolder folder;
  Running team(python_team("yellow", {"--no-echo"}));
  const Outcome played = match("idle", "firasim:py", folder / "leg.json",
                               {"--speed", "8", "--half", "8", "--rule", "ready_s=0.33"});
  ASSERT_EQ(played.exit_code, 0) << played.err;
  const Json record = read_json(folder / "leg.json");
  EXPECT_EQ(record["result"]["end"], "full_time") << record["result"].dump();
  EXPECT_GT(record["pace"]["period"], 0.0);
  EXPECT_EQ(run({program("mirocup"), "verify", folder / "leg.json"}).exit_code, 0);
}

// Catches a datagram of a stranger that moves a robot, a ball or the match: with thousands of them
// the leg is the same one, bit for bit, and the record has counted them. Build it with
// MIROCUP_HOSTILE_DATAGRAMS=100000 in the environment for the long run.
TEST(Firasim, StrangersHaveNoEffect) {
  const char* wanted = std::getenv("MIROCUP_HOSTILE_DATAGRAMS");
  const std::string count = wanted != nullptr ? wanted : "2000";
  std::string hash;
  for (const bool with_stranger : {false, true}) {
    const TemporaryFolder folder;
    Running team(python_team("blue"));
    Running leg({program("mirocup"), "match", "--blue", "firasim:py", "--yellow", "idle", "--rules",
                 "vsss", "--record", folder / "leg.json", "--firasim-instance", instance(),
                 "--lockstep", "--half", wanted != nullptr ? "100" : "8", "--rule",
                 "ready_s=0.33"});
    // The team has its seat before the stranger comes: a free seat is for whoever comes first.
    ASSERT_TRUE(wait_until([&] { return leg.err().find("is steered from") != std::string::npos; }));
    std::unique_ptr<Running> stranger;
    if (with_stranger) {
      stranger = std::make_unique<Running>(std::vector<std::string>{
          "/usr/bin/env", "PYTHONDONTWRITEBYTECODE=1", "python3",
          MIROCUP_SOURCE_FOLDER "/tests/programs/firasim/hostile.py", instance(), count});
    }
    const Outcome played = leg.wait();
    ASSERT_EQ(played.exit_code, 0) << played.err;
    const Json record = read_json(folder / "leg.json");
    EXPECT_EQ(record["result"]["end"], "full_time") << record["result"].dump();
    if (with_stranger) {
      const Json& network = record["network"]["blue"];
      EXPECT_EQ(record["state_hash"], hash);
      EXPECT_GT(network["foreign"], 0);
      EXPECT_GT(network["datagrams"]["malformed"], 0);
      EXPECT_GT(network["datagrams"]["replacements"], 0);
      EXPECT_EQ(network["processes"], 1);
    }
    hash = record["state_hash"];
  }
}

// Catches a team that is gone and still plays, and a leg that waits for ever.
TEST(Firasim, ATeamThatGoesHasLost) {
  const TemporaryFolder folder;
  auto team = std::make_unique<Running>(python_team("blue"));
  Running leg({program("mirocup"), "match", "--blue", "firasim:py", "--yellow", "idle", "--rules",
               "vsss", "--record", folder / "leg.json", "--firasim-instance", instance(),
               "--away-limit", "1", "--speed", "1"});
  ASSERT_TRUE(wait_until([&] { return leg.err().find("is steered from") != std::string::npos; }));
  team.reset();  // kills it
  const Outcome played = leg.wait();
  EXPECT_EQ(played.exit_code, 0) << played.err;
  const Json record = read_json(folder / "leg.json");
  EXPECT_EQ(record["result"]["end"], "forfeit");
  EXPECT_EQ(record["result"]["fault"]["code"], "disconnected");
  EXPECT_EQ(record["result"]["winner"], "yellow");
}

TEST(Firasim, SaysWhatIsWrongWithAnAddress) {
  const auto fails = [](const std::vector<std::string>& more, const std::string& text) {
    const Outcome outcome = match("firasim:py", "idle", "/dev/null", more);
    EXPECT_EQ(outcome.exit_code, 2) << outcome.err;
    EXPECT_NE(outcome.err.find(text), std::string::npos) << outcome.err;
  };
  fails({"--firasim-vision", "224.0.0.1"}, "--firasim-vision 224.0.0.1: ADDRESS:PORT");
  fails({"--firasim-command", "70000"}, "--firasim-command");
  EXPECT_EQ(match("firasim:", "idle", "/dev/null", {}).exit_code, 2);
}

}  // namespace
}  // namespace mirocup
