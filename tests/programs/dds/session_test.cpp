// SPDX-License-Identifier: MIT
//
// Teams on the network that die, stop, come back or are impostors, as real processes.
#include "tests/programs/dds/network.hpp"
#include "tests/programs/dds/own_host.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>

namespace mirocup {
namespace {

using namespace test_support;

std::string team(const std::string& name) {
  return program("teams/" + name + ".so");
}

std::vector<std::string> match(const std::string& id, const std::string& record,
                               const std::vector<std::string>& more) {
  std::vector<std::string> arguments{program("mirocup"), "match",  "--blue",  "dds:remote",
                                     "--yellow",         "keeper", "--match", id,
                                     "--record",         record};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

// Returns the absence of a team whose process is stopped in tick 30. On a busy machine the team may
// have been late a little earlier, or may have had another absence before.
nlohmann::ordered_json absence_of_tick_30(const nlohmann::ordered_json& record) {
  for (const auto& absence : record["network"]["blue"]["absences"]) {
    if (absence["noticed"] < 30) continue;
    EXPECT_LE(absence["noticed"].get<int>() - absence["tick"].get<int>(), 10);
    return absence;
  }
  return nullptr;
}

// A team that vanishes in real time is noticed within ten ticks and loses after the limit.
TEST(DdsSession, NoticesWithinTenTicksThatATeamWasKilled) {
  const TemporaryFolder folder;
  const std::string id = match_id("killed");
  Running leg(match(id, folder / "leg.json", {"--speed", "1", "--away-limit", "3"}));
  Running remote(join(id, "blue", "remote", team("dies")));
  EXPECT_EQ(remote.wait().exit_code, 128 + SIGKILL);
  ASSERT_EQ(leg.wait().exit_code, 0);
  const auto record = read_json(folder / "leg.json");
  EXPECT_EQ(record["result"]["end"], "forfeit");
  EXPECT_EQ(record["result"]["winner"], "yellow");
  EXPECT_EQ(record["result"]["fault"]["code"], "disconnected");
  const auto absence = absence_of_tick_30(record);
  ASSERT_FALSE(absence.is_null());
  EXPECT_LE(absence["tick"], 30);
  EXPECT_LE(absence["noticed"], 40);
  EXPECT_TRUE(absence["back"].is_null());
  EXPECT_EQ(record["network"]["blue"]["absences"].back(), absence);
  EXPECT_EQ(run_mirocup({"verify", folder / "leg.json"}).exit_code, 0);
}

// Both teams take long to load and to decide. Catches a server that is silent while it waits for a
// process, and a team that leaves without a look at what came while it was at work.
TEST(DdsSession, StaysWhileEitherTeamIsSlow) {
  const TemporaryFolder folder;
  const std::string id = match_id("slow");
  write_file(folder / "slow.py",
             "from mirocup.team import Team\n"
             "import time\n"
             "class Slow(Team):\n"
             "    def __init__(self, setup):\n"
             "        super().__init__(setup); time.sleep(self.parameter('start', 1))\n"
             "    def decide(self, now):\n"
             "        return now.tick == self.parameter('tick', 9) and time.sleep(0.7) or []\n");
  Running remote(join(id, "blue", "remote", folder / "slow.py"));
  const Outcome played =
      expect_exit(0, run_mirocup({"match", "--blue", "dds:remote", "--yellow", folder / "slow.py",
                                  "--half", "1", "--match", id, "--yellow-param", "start=4",
                                  "--yellow-param", "tick=19", "--record", folder / "leg.json"}));
  expect_exit(0, remote.wait());
  EXPECT_EQ(played.err.find("has joined the network anew"), std::string::npos) << played.err;
  EXPECT_EQ(read_json(folder / "leg.json")["result"]["end"], "full_time");
}

// Two servers with one ID would tear the team apart between their legs.
TEST(DdsSession, RefusesASecondServerWithTheSameId) {
  const TemporaryFolder folder;
  const std::string id = match_id("twice");
  Running leg(match(id, folder / "leg.json", {"--half", "5"}));
  ASSERT_TRUE(is_there(leg));
  expect_exit(3, run(match(id, folder / "second.json", {"--half", "5"})),
              "is already played by another match server");
  Running remote(join(id, "blue", "remote", "striker"));
  EXPECT_EQ(leg.wait().exit_code, 0);
  EXPECT_EQ(remote.wait().exit_code, 0);
  EXPECT_EQ(read_json(folder / "leg.json")["result"]["end"], "full_time");
}

// The server's own network is down. Catches a leg that a team loses by it.
TEST(DdsSession, IsVoidWhenTheHostsNetworkIsDown) {
  if (run({"/usr/sbin/ip", "link", "set", "lo", "up"}).exit_code != 0) {
    GTEST_SKIP() << "needs ip and a host of its own";
  }
  for (const std::string speed : {"1", "max"}) {
    const TemporaryFolder folder;
    const std::string id = match_id("host-" + speed);
    Running leg(
        match(id, folder / "leg.json", {"--speed", speed, "--half", "3000", "--away-limit", "1"}));
    Running remote(join(id, "blue", "remote", "striker"));
    ASSERT_TRUE(has_said(remote, "remote plays blue"));
    run({"/usr/sbin/ip", "link", "set", "lo", "down"});
    const Outcome played = leg.wait();
    run({"/usr/sbin/ip", "link", "set", "lo", "up"});
    EXPECT_EQ(played.exit_code, 5) << played.err;
    const auto record = read_json(folder / "leg.json");
    EXPECT_EQ(record["result"]["end"], "void");
    EXPECT_TRUE(contains(record["result"]["why_void"].get<std::string>(), "interface lo was down"));
  }
}

// The team's host leaves one network for another. Catches sockets that keep the former address.
TEST(DdsSession, TakesBackATeamWhoseHostHasAnotherAddress) {
  const auto ip = [](const std::string& words) {
    return run({"/bin/sh", "-c", "/usr/sbin/ip " + words}).exit_code == 0;
  };
  const auto take_address = [&ip](const std::string& last) {
    return ip("addr add 10.9.0." + last + "/32 dev home") &&
           ip("route replace table local local 10.9.0.1 dev home src 10.9.0." + last);
  };
  if (!is_on_own_host() || !ip("link add home type veth peer name router")) {
    GTEST_SKIP() << "needs ip and a host of its own";
  }
  ASSERT_TRUE(ip("link set home up") && ip("link set router up") &&
              ip("addr add 10.9.0.1/32 dev home") && take_address("2"));
  const TemporaryFolder folder;
  const std::string id = match_id("moves");
  Running leg(match(id, folder / "leg.json",
                    {"--speed", "1", "--half", "4", "--away-limit", "60", "--interface", "home"}));
  Running remote(join(id, "blue", "remote", team("goes_on"), {"--server", "10.9.0.1"}));
  // Before the first tick nobody is absent.
  ASSERT_TRUE(has_said(remote, "tick 2")) << remote.err();
  EXPECT_TRUE(ip("addr del 10.9.0.2/32 dev home") && take_address("3"));
  ASSERT_EQ(leg.wait().exit_code, 0);
  EXPECT_EQ(remote.wait().exit_code, 0);
  const auto record = read_json(folder / "leg.json");
  EXPECT_EQ(record["result"]["end"], "full_time") << record["result"];
  const auto network = record["network"]["blue"];
  EXPECT_EQ(network["processes"], 1);
  EXPECT_GT(network["in_step"], 0);
  EXPECT_FALSE(network["absences"].empty());
  ip("link del home");
}

// Ends both teams with one signal each, `first` first, and expects that nobody wins.
void expect_no_winner(int signal, const std::string& first, const std::string& speed) {
  const TemporaryFolder folder;
  const std::string id = match_id("both-" + std::to_string(signal) + first + speed);
  Running leg({program("mirocup"), "match", "--blue", "dds:one", "--yellow", "dds:two", "--match",
               id, "--speed", speed, "--half", "3000", "--away-limit", "2", "--record",
               folder / "leg.json"});
  Running blue(join(id, "blue", "one", team("goes_on")));
  Running yellow(join(id, "yellow", "two", team("goes_on")));
  // Both have then answered an earlier tick; otherwise they have not joined in time.
  ASSERT_TRUE(has_said(blue, "tick 2")) << blue.err();
  ASSERT_TRUE(has_said(yellow, "tick 2")) << yellow.err();
  (first == "blue" ? blue : yellow).signal(signal);
  (first == "blue" ? yellow : blue).signal(signal);
  const Outcome played = expect_exit(0, leg.wait());
  const auto result = read_json(folder / "leg.json")["result"];
  EXPECT_EQ(result["end"], "double_forfeit") << result << played.err;
  EXPECT_TRUE(result["winner"].is_null());
  for (const auto& fault : result["faults"]) EXPECT_EQ(fault["code"], "disconnected");
}

TEST(DdsSession, IsWonByNobodyWhenBothTeamsAreKilledOrStoppedAtOnce) {
  for (const int signal : {SIGKILL, SIGSTOP}) {
    for (const char* first : {"blue", "yellow"}) {
      for (const char* speed : {"1", "max"}) expect_no_winner(signal, first, speed);
    }
  }
}

// One team joins and dies, the other one never comes. Catches a winner that is not there.
TEST(DdsSession, IsWonByNobodyWhenOneTeamDiesBeforeTheStartAndTheOtherDoesNotCome) {
  const TemporaryFolder folder;
  const std::string id = match_id("before");
  Running leg({program("mirocup"), "match", "--blue", "dds:one", "--yellow", "dds:two", "--match",
               id, "--join-within", "10", "--record", folder / "leg.json"});
  Running blue(join(id, "blue", "one", "striker"));
  ASSERT_TRUE(has_said(blue, "one plays blue"));
  blue.signal(SIGKILL);
  EXPECT_EQ(leg.wait().exit_code, 0);
  EXPECT_EQ(read_json(folder / "leg.json")["result"]["end"], "double_forfeit");
}

TEST(DdsSession, LetsAStoppedTeamGoOn) {
  const TemporaryFolder folder;
  const std::string id = match_id("stopped");
  // Long enough for the team to come back on a busy machine, here and below.
  Running leg(
      match(id, folder / "leg.json", {"--speed", "1", "--half", "4", "--away-limit", "60"}));
  Running remote(join(id, "blue", "remote", team("stops")));
  ASSERT_TRUE(has_said(leg, "the team is silent")) << leg.err();
  remote.signal(SIGCONT);
  ASSERT_EQ(leg.wait().exit_code, 0);
  EXPECT_EQ(remote.wait().exit_code, 0);
  const auto record = read_json(folder / "leg.json");
  EXPECT_EQ(record["result"]["end"], "full_time");
  const auto network = record["network"]["blue"];
  EXPECT_EQ(network["processes"], 1);
  const auto absence = absence_of_tick_30(record);
  ASSERT_FALSE(absence.is_null());
  EXPECT_LE(absence["tick"], 30);
  EXPECT_LE(absence["noticed"], 40);
  EXPECT_EQ(absence["why"], "silent");
  EXPECT_GE(absence["back"], absence["noticed"]);
  // The clock of the match went on.
  std::uint64_t ticks = 0;
  for (const auto& range : record["pace"]["lateness"]["histogram"]) {
    ticks += range[1].get<std::uint64_t>();
  }
  EXPECT_EQ(ticks, record["ticks"]);
  EXPECT_GT(network["answers"]["p50"], 0.0);
}

// A team is killed and started again, in real time and in lockstep.
// `earliest`: the first tick from which the killed process may have owed an answer.
void expect_restart_works(const std::vector<std::string>& pace, int earliest) {
  const TemporaryFolder folder;
  const std::string id = match_id("restarted");
  Running leg(match(id, folder / "leg.json", pace));
  Running first(join(id, "blue", "remote", team("dies")));
  EXPECT_EQ(first.wait().exit_code, 128 + SIGKILL);
  Running second(join(id, "blue", "remote", "chaser"));
  ASSERT_EQ(leg.wait().exit_code, 0);
  EXPECT_EQ(second.wait().exit_code, 0);
  const auto record = read_json(folder / "leg.json");
  EXPECT_EQ(record["result"]["end"], "full_time") << record["result"].dump();
  const auto network = record["network"]["blue"];
  EXPECT_EQ(network["processes"], 2);
  const auto absence = absence_of_tick_30(record);
  ASSERT_FALSE(absence.is_null());
  EXPECT_LE(absence["tick"], 30);
  EXPECT_GE(absence["tick"], earliest);
  EXPECT_FALSE(absence["back"].is_null());
  EXPECT_EQ(run_mirocup({"verify", folder / "leg.json"}).exit_code, 0);
}

TEST(DdsSession, TakesATeamBackInRealTimeAndInLockstep) {
  expect_restart_works({"--speed", "1", "--half", "5", "--away-limit", "60"}, 20);
  expect_restart_works({"--half", "5"}, 30);
}

// The team's process stays and plays the new leg from its start.
TEST(DdsSession, PlaysOnWhenTheServerIsStartedAgain) {
  const TemporaryFolder folder;
  const std::string id = match_id("server");
  Running remote(join(id, "blue", "remote", "striker"));
  {
    Running leg(match(id, folder / "first.json", {"--speed", "1"}));
    ASSERT_TRUE(has_said(remote, "remote plays blue")) << remote.err();
    leg.signal(SIGKILL);
    leg.wait();
  }
  Running leg(match(id, folder / "leg.json", {"--half", "5", "--seed", "3"}));
  ASSERT_EQ(leg.wait().exit_code, 0);
  EXPECT_EQ(remote.wait().exit_code, 0);
  run_mirocup({"match", "--blue", "striker", "--yellow", "keeper", "--half", "5", "--seed", "3",
               "--record", folder / "so.json"});
  EXPECT_EQ(read_json(folder / "leg.json")["state_hash"],
            read_json(folder / "so.json")["state_hash"]);
}

TEST(DdsSession, KeepsTheSeatForTheProcessThatPlays) {
  const TemporaryFolder folder;
  const std::string id = match_id("second");
  Running leg(match(id, folder / "leg.json", {"--speed", "0.2"}));
  Running first(join(id, "blue", "remote", "striker"));
  ASSERT_TRUE(has_said(first, "remote plays blue"));
  const std::string reason = "another process of the team is playing";
  const Outcome told = run_until_said(reason, [&id](const std::string& limit) {
    return run(join(id, "blue", "remote", "chaser", {"--join-within", limit}));
  });
  expect_exit(3, told, reason);
  EXPECT_FALSE(contains(leg.err(), "takes the team's seat"));
}

// A leg with an intruder is that without one. In open mode every process can read a team's nonce
// and write its commands, but only those of the seated process count. Writers of other types under
// the names of the topics never match. A process may acknowledge nothing, and many may ask for the
// seat.
class Intruder : public testing::TestWithParam<const char*> {};

TEST_P(Intruder, HasNoEffect) {
  const TemporaryFolder folder;
  const std::string kind = GetParam();
  const std::string id = match_id(kind);
  Running leg(match(id, folder / "leg.json", {"--half", "10"}));
  Running intruder({program("dds/intruder"), kind, id, "remote"});
  ASSERT_TRUE(has_said(intruder, "there")) << intruder.err();
  Running remote(join(id, "blue", "remote", "striker"));
  ASSERT_EQ(leg.wait().exit_code, 0);
  run_mirocup({"match", "--blue", "striker", "--yellow", "keeper", "--half", "10", "--record",
               folder / "so.json"});
  const auto record = read_json(folder / "leg.json");
  EXPECT_EQ(record["state_hash"], read_json(folder / "so.json")["state_hash"]);
  if (kind == "flood") EXPECT_GT(record["network"]["blue"]["foreign"], 0);
}

INSTANTIATE_TEST_SUITE_P(DdsSession, Intruder,
                         testing::Values("flood", "wrong_types", "stuck", "hellos"),
                         [](const auto& kind) { return std::string(kind.param); });

}  // namespace
}  // namespace mirocup
