// SPDX-License-Identifier: MIT
//
// Teams on the network that die, stop, come back or are impostors, as real processes.
#include "tests/programs/dds/network.hpp"

#include <gtest/gtest.h>

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
  Running leg(match(id, folder / "leg.json", {"--speed", "1", "--away-limit", "0.5"}));
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
  EXPECT_EQ(run({program("mirocup"), "verify", folder / "leg.json"}).exit_code, 0);
}

TEST(DdsSession, LetsAStoppedTeamGoOn) {
  const TemporaryFolder folder;
  const std::string id = match_id("stopped");
  Running leg(match(id, folder / "leg.json", {"--speed", "1", "--half", "1"}));
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
  EXPECT_EQ(run({program("mirocup"), "verify", folder / "leg.json"}).exit_code, 0);
}

TEST(DdsSession, TakesATeamBackInRealTime) {
  expect_restart_works({"--speed", "1", "--half", "1.5"}, 20);
}

TEST(DdsSession, TakesATeamBackInLockstep) {
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
  run({program("mirocup"), "match", "--blue", "striker", "--yellow", "keeper", "--half", "5",
       "--seed", "3", "--record", folder / "so.json"});
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
  const Outcome second = run_until_said(reason, [&id](const std::string& patience) {
    auto arguments = join(id, "blue", "remote", "chaser");
    arguments.insert(arguments.end(), {"--patience", patience});
    return run(arguments);
  });
  EXPECT_EQ(second.exit_code, 3);
  EXPECT_NE(second.err.find(reason), std::string::npos) << second.err;
  EXPECT_EQ(leg.err().find("takes its seat"), std::string::npos) << leg.err();
}

// Compares the state hash of a leg with an intruder to that of a leg without one.
void expect_no_effect(const std::string& kind) {
  const TemporaryFolder folder;
  const std::string id = match_id(kind);
  Running leg(match(id, folder / "leg.json", {"--half", "10"}));
  Running intruder({program("dds/intruder"), kind, id, "remote"});
  ASSERT_TRUE(has_said(intruder, "there")) << intruder.err();
  Running remote(join(id, "blue", "remote", "striker"));
  ASSERT_EQ(leg.wait().exit_code, 0);
  run({program("mirocup"), "match", "--blue", "striker", "--yellow", "keeper", "--half", "10",
       "--record", folder / "so.json"});
  const auto record = read_json(folder / "leg.json");
  EXPECT_EQ(record["state_hash"], read_json(folder / "so.json")["state_hash"]) << kind;
  if (kind == "imitate" || kind == "flood") {
    EXPECT_GT(record["network"]["blue"]["foreign"], 0);
  }
}

// In open mode every process can read a team's nonce and write its commands, but only those of the
// seated process count.
TEST(DdsSession, IgnoresASecondWriter) {
  expect_no_effect("imitate");
}

TEST(DdsSession, IgnoresAFloodOfCommands) {
  expect_no_effect("flood");
}

// Writers of other types under the names of the topics never match.
TEST(DdsSession, IgnoresOtherTypesUnderTheRightNames) {
  expect_no_effect("wrong_types");
}

// A process reads all topics and never acknowledges a sample.
TEST(DdsSession, DoesNotWaitForAStuckReader) {
  expect_no_effect("stuck");
}

// Many processes ask for the seat.
TEST(DdsSession, AnswersItsTeamAmongManyHellos) {
  expect_no_effect("hellos");
}

}  // namespace
}  // namespace mirocup
