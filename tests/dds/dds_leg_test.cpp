// SPDX-License-Identifier: MIT
//
// Teams over real Cyclone DDS on the loopback interface.
#include "tests/support/program.hpp"

#include <gtest/gtest.h>

#include <csignal>
#include <unistd.h>

namespace mirocup {
namespace {

using test_support::Outcome;
using test_support::program;
using test_support::read_json;
using test_support::run;
using test_support::Running;
using test_support::TemporaryFolder;

// Matches of tests that run at the same time must not meet.
std::string match_id(const std::string& name) {
  return name + "-" + std::to_string(getpid());
}

std::vector<std::string> join(const std::string& id, const std::string& colour,
                              const std::string& name, const std::string& team) {
  return {program("mirocup"),
          "join",
          "--match",
          id,
          "--team",
          colour,
          "--name",
          name,
          program("house/" + team + ".so")};
}

TEST(DdsTeam, PlaysTheSameLegAsItsLibrary) {
  const TemporaryFolder folder;
  const std::string id = match_id("same");
  Running remote(join(id, "blue", "remote", "striker"));
  const Outcome over_dds =
      run({program("mirocup"), "match", "--blue", "dds:remote", "--yellow", "chaser", "--half",
           "30", "--match", id, "--record", folder / "dds.json"});
  ASSERT_EQ(over_dds.exit_code, 0) << over_dds.err;
  EXPECT_EQ(remote.wait().exit_code, 0);
  run({program("mirocup"), "match", "--blue", "striker", "--yellow", "chaser", "--half", "30",
       "--record", folder / "so.json"});

  const auto dds = read_json(folder / "dds.json");
  EXPECT_EQ(dds["teams"]["blue"]["kind"], "dds");
  EXPECT_EQ(dds["teams"]["blue"]["name"], "remote");
  EXPECT_TRUE(dds["teams"]["blue"]["sha256"].is_null());
  EXPECT_EQ(dds["result"]["end"], "full_time");
  EXPECT_EQ(dds["state_hash"], read_json(folder / "so.json")["state_hash"]);
  EXPECT_EQ(run({program("mirocup"), "verify", folder / "dds.json"}).exit_code, 0);
}

TEST(DdsTeam, MayMeetAnother) {
  const TemporaryFolder folder;
  const std::string id = match_id("both");
  Running blue(join(id, "blue", "one", "striker"));
  Running yellow(join(id, "yellow", "two", "keeper"));
  const Outcome played =
      run({program("mirocup"), "match", "--blue", "dds:one", "--yellow", "dds:two", "--half", "5",
           "--match", id, "--record", folder / "leg.json"});
  EXPECT_EQ(played.exit_code, 0) << played.err;
  EXPECT_EQ(blue.wait().exit_code, 0);
  EXPECT_EQ(yellow.wait().exit_code, 0);
  EXPECT_EQ(run({program("mirocup"), "verify", folder / "leg.json"}).exit_code, 0);
}

TEST(DdsTeam, LosesWhenItVanishes) {
  const TemporaryFolder folder;
  const std::string id = match_id("vanish");
  Running remote(join(id, "yellow", "remote", "striker"));
  Running match({program("mirocup"), "match", "--blue", "idle", "--yellow", "dds:remote", "--half",
                 "60", "--match", id, "--speed", "1", "--record", folder / "leg.json"});
  sleep(3);
  remote.signal(SIGKILL);
  EXPECT_EQ(match.wait().exit_code, 0);
  const auto record = read_json(folder / "leg.json");
  EXPECT_EQ(record["result"]["end"], "forfeit");
  EXPECT_EQ(record["result"]["fault"]["code"], "disconnected");
  EXPECT_EQ(record["result"]["winner"], "blue");
  EXPECT_GT(record["budget"]["yellow"]["late_ticks"], 0);
}

TEST(DdsTeam, LosesWhenItDoesNotCome) {
  const TemporaryFolder folder;
  const Outcome played =
      run({program("mirocup"), "match", "--blue", "dds:nobody", "--yellow", "idle", "--half", "5",
           "--match", match_id("empty"), "--join-within", "1", "--record", folder / "leg.json"});
  EXPECT_EQ(played.exit_code, 0) << played.err;
  EXPECT_EQ(read_json(folder / "leg.json")["result"]["fault"]["code"], "start_timeout");
}

TEST(DdsTeam, IsRefusedUnderAnotherName) {
  const std::string id = match_id("name");
  Running match({program("mirocup"), "match", "--blue", "dds:expected", "--yellow", "idle",
                 "--half", "5", "--match", id, "--join-within", "5"});
  const Outcome stranger = run(join(id, "blue", "stranger", "idle"));
  EXPECT_EQ(stranger.exit_code, 3);
  EXPECT_NE(stranger.err.find("expected"), std::string::npos) << stranger.err;
}

// Neither side may be deaf to Ctrl-C while it waits for the other.
TEST(DdsTeam, CanBeInterruptedWhileItIsAwaited) {
  Running server({program("mirocup"), "match", "--blue", "dds:nobody", "--yellow", "idle",
                  "--match", "interrupted-server"});
  Running team({program("mirocup"), "join", "--match", "interrupted-team", "--team", "blue",
                "--name", "lonely", program("house/idle.so")});
  usleep(700'000);
  server.signal(SIGINT);
  team.signal(SIGTERM);
  EXPECT_EQ(server.wait().exit_code, 130);
  EXPECT_EQ(team.wait().exit_code, 130);
}

}  // namespace
}  // namespace mirocup
