// SPDX-License-Identifier: MIT
//
// Whole legs of programs that speak FIRASim's protocol: our example in Python, and a client in C++
// with libprotobuf.
#include "tests/support/program.hpp"

#include <gtest/gtest.h>

#include <arpa/inet.h>
#include <filesystem>
#include <iostream>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

namespace mirocup {
namespace {

using namespace test_support;
using Json = nlohmann::ordered_json;

// Ports of its own for each test process, because tests run at the same time.
std::string instance() {
  return std::to_string(2000 + getpid() % 7000);
}

// A port of this host that nobody has now.
std::string free_port() {
  const int socket = ::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  sockaddr_in at{};
  at.sin_family = AF_INET;
  at.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t length = sizeof at;
  bind(socket, reinterpret_cast<const sockaddr*>(&at), length);
  getsockname(socket, reinterpret_cast<sockaddr*>(&at), &length);
  close(socket);
  return std::to_string(ntohs(at.sin_port));
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

// How often one leg is played; MIROCUP_FIRASIM_RUNS=10 in the environment for the long run.
int runs() {
  const char* wanted = std::getenv("MIROCUP_FIRASIM_RUNS");
  return wanted != nullptr ? std::atoi(wanted) : 2;
}

// How many times the referee has stopped play and placed the bodies.
int restarts_of(const Json& record) {
  int count = 0;
  for (const Json& decision : record["decisions"]) count += decision["restart"].is_null() ? 0 : 1;
  return count;
}

// Catches commands of one colour that drive the other, a second half with the wrong frame, and an
// answer that belongs to another tick: then the same seed has different legs.
TEST(Firasim, InLockstepTheSameSeedIsTheSameLeg) {
  for (const std::string colour : {"blue", "yellow"}) {
    std::string hash;
    for (int i = 0; i < runs(); ++i) {
      const TemporaryFolder folder;
      Running team(python_team(colour));
      const bool is_blue = colour == "blue";
      expect_exit(
          0, match(is_blue ? "firasim:py" : "idle", is_blue ? "idle" : "firasim:py",
                   folder / "leg.json", {"--lockstep", "--half", "15", "--rule", "ready_s=0.33"}));
      EXPECT_EQ(team.wait().exit_code, 0);
      const Json record = read_json(folder / "leg.json");
      EXPECT_EQ(record["result"]["end"], "full_time") << record["result"].dump();
      EXPECT_EQ(record["teams"][colour]["kind"], "firasim");
      EXPECT_EQ(record["network"][colour]["in_step"], record["ticks"]);
      // It asks for places in the field's own half: in both colours, at every restart.
      EXPECT_GE(restarts_of(record), 2);
      EXPECT_GE(record["network"][colour]["datagrams"]["placements"], restarts_of(record));
      EXPECT_GT(record["result"]["score"][colour], 0) << "its robots go the wrong way";
      EXPECT_TRUE(i == 0 || record["state_hash"] == hash);
      hash = record["state_hash"].get<std::string>();
      EXPECT_EQ(run_mirocup({"verify", folder / "leg.json"}).exit_code, 0);
    }
  }
}

// Catches an encoding that only our own decoder reads, one datagram for each robot taken for a
// whole answer, and a placement that is not used: the clients look where their robots stand.
TEST(Firasim, ClientsWithProtobufPlayEachOther) {
  if (!std::filesystem::exists(program("firasim_client"))) GTEST_SKIP() << "built without protobuf";
  const TemporaryFolder folder;
  Running blue({program("firasim_client"), "blue", instance()});
  Running yellow({program("firasim_client"), "yellow", instance()});
  expect_exit(
      0, match("firasim:one", "firasim:two", folder / "leg.json", {"--lockstep", "--half", "8"}));
  for (Running* client : {&blue, &yellow}) {
    expect_exit(0, client->wait());
  }
  const Json record = read_json(folder / "leg.json");
  EXPECT_EQ(record["result"]["end"], "full_time") << record["result"].dump();
  EXPECT_EQ(record["isolation"], "network");
  for (const char* colour : {"blue", "yellow"}) {
    const Json& network = record["network"][colour];
    EXPECT_EQ(network["in_step"], record["ticks"]);
    EXPECT_EQ(network["processes"], 1);
    EXPECT_GE(network["datagrams"]["placements"], restarts_of(record));
  }
  EXPECT_EQ(run_mirocup({"verify", folder / "leg.json"}).exit_code, 0);
}

// Catches a client without `step` that gets a vision twice, or whose answers come a tick too late
// when it is slow or quick: whether it waits or asks its sockets all the time, the leg is the same.
TEST(Firasim, ABusyClientPlaysTheSameLeg) {
  if (!std::filesystem::exists(program("firasim_client"))) GTEST_SKIP() << "built without protobuf";
  std::string hash;
  for (const char* way : {"waits", "busy"}) {
    const TemporaryFolder folder;
    Running client({program("firasim_client"), "yellow", instance(), way});
    expect_exit(
        0, match("idle", "firasim:two", folder / "leg.json",
                 {"--lockstep", "--half", "4", "--rule", "ready_s=0.33", "--away-limit", "60"}));
    expect_exit(0, client.wait());
    const Json record = read_json(folder / "leg.json");
    EXPECT_EQ(record["network"]["yellow"]["in_step"], record["ticks"]);
    EXPECT_TRUE(hash.empty() || record["state_hash"] == hash) << way;
    hash = record["state_hash"].get<std::string>();
  }
}

// Catches a match that waits for a team by its own clock although real time passes.
TEST(Firasim, PlaysByTheClock) {
  const TemporaryFolder folder;
  Running team(python_team("yellow", {"--no-echo"}));
  expect_exit(0, match("idle", "firasim:py", folder / "leg.json",
                       {"--speed", "8", "--half", "8", "--rule", "ready_s=0.33"}));
  const Json record = read_json(folder / "leg.json");
  EXPECT_EQ(record["result"]["end"], "full_time") << record["result"].dump();
  EXPECT_GT(record["pace"]["period"], 0.0);
  EXPECT_EQ(run_mirocup({"verify", folder / "leg.json"}).exit_code, 0);
}

// Catches a datagram of a stranger that moves a robot, a ball or the match: with thousands of them
// the leg is the same one, bit for bit, and the record has counted them. Some come in floods.
// MIROCUP_HOSTILE_DATAGRAMS=100000 in the environment is the long run.
TEST(Firasim, StrangersHaveNoEffect) {
  const char* wanted = std::getenv("MIROCUP_HOSTILE_DATAGRAMS");
  const std::string count = wanted != nullptr ? wanted : "2000";
  const std::string flood = "3000";  // after each thousand
  std::string hash;
  for (const bool with_strangers : {false, true}) {
    const TemporaryFolder folder;
    const std::vector<std::string> with{"/usr/bin/env",
                                        "PYTHONDONTWRITEBYTECODE=1",
                                        "python3",
                                        MIROCUP_SOURCE_FOLDER "/tests/programs/firasim/hostile.py",
                                        instance(),
                                        count,
                                        "1",
                                        flood};
    Running team(with_strangers ? with : python_team("blue"));
    expect_exit(0, match("firasim:py", "idle", folder / "leg.json",
                         {"--lockstep", "--half", wanted != nullptr ? "100" : "8", "--rule",
                          "ready_s=0.33", "--rule", "mercy_goal_diff=0"}));
    const Json record = read_json(folder / "leg.json");
    EXPECT_EQ(record["result"]["end"], "full_time") << record["result"].dump();
    if (with_strangers) {
      const Json& network = record["network"]["blue"];
      EXPECT_EQ(record["state_hash"], hash);
      EXPECT_GT(network["foreign"], 0);
      EXPECT_GT(network["datagrams"]["malformed"], 0);
      EXPECT_GT(network["datagrams"]["replacements"], 0);
      EXPECT_EQ(network["processes"], 1);
      // Each is foreign or malformed; what the system dropped in a flood, nobody has counted.
      const int counted =
          network["foreign"].get<int>() + network["datagrams"]["malformed"].get<int>();
      EXPECT_GE(counted, std::stoi(count) / 2);
      const Outcome sent = team.wait();
      std::cout << "sent " << sent.out << "counted: foreign " << network["foreign"] << ", "
                << network["datagrams"].dump() << ", ticks " << record["ticks"] << '\n';
    }
    hash = record["state_hash"].get<std::string>();
  }
}

// Catches an answer that is driven twice or in the wrong tick, and a match that stops where a
// packet is lost: over a wire that loses and doubles, the leg is the same one.
TEST(Firasim, LostAndDoubledPacketsHaveNoEffect) {
  std::string hash;
  for (const bool is_bad : {false, true}) {
    const TemporaryFolder folder;
    const std::string vision = free_port(), seen = free_port();
    const std::string commands = free_port(), placements = free_port();
    const int k = std::stoi(instance());
    std::unique_ptr<Running> wire;
    std::vector<std::string> ways, options{"--lockstep", "--half", "5", "--rule", "ready_s=0.33"};
    if (is_bad) {
      wire = std::make_unique<Running>(std::vector<std::string>{
          "/usr/bin/env", "python3", MIROCUP_SOURCE_FOLDER "/tests/programs/firasim/wire.py",
          "0.01", "0.02", "1", vision + ":127.0.0.1:" + seen,
          commands + ":127.0.0.1:" + std::to_string(20011 + k),
          placements + ":224.5.23.2:" + std::to_string(50000 + k)});
      ASSERT_TRUE(wait_until([&] { return wire->out().find("ready") != std::string::npos; }));
      ways = {"--vision",    "127.0.0.1:" + seen,      "--command", "127.0.0.1:" + commands,
              "--placement", "127.0.0.1:" + placements};
      options.insert(options.end(), {"--firasim-vision", "127.0.0.1:" + vision});
    }
    Running team(python_team("blue", ways));
    expect_exit(0, match("firasim:py", "idle", folder / "leg.json", options));
    const Json record = read_json(folder / "leg.json");
    EXPECT_EQ(record["result"]["end"], "full_time") << record["result"].dump();
    const Json& network = record["network"]["blue"];
    EXPECT_EQ(network["in_step"], record["ticks"]);
    if (is_bad) {
      EXPECT_EQ(record["state_hash"], hash);
      EXPECT_GT(network["datagrams"]["stale"], 0) << "nothing was doubled";
    }
    hash = record["state_hash"].get<std::string>();
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
  expect_exit(0, leg.wait());
  const Json record = read_json(folder / "leg.json");
  EXPECT_EQ(record["result"]["end"], "forfeit");
  EXPECT_EQ(record["result"]["fault"]["code"], "disconnected");
  EXPECT_EQ(record["result"]["winner"], "yellow");
}

}  // namespace
}  // namespace mirocup
