// SPDX-License-Identifier: MIT
//
// Catches a record that differs from the leg, one that reads back differently, and damage that is
// not found.
#include "record/match_record.hpp"

#include "core/replay/verification.hpp"
#include "system/digest.hpp"
#include "tests/support/controllers.hpp"
#include "tests/support/is_ok.hpp"
#include "tests/support/memory_files.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace mirocup::record {
namespace {

using test_support::MemoryFiles;

MatchRecord played(std::uint64_t seed, League league = League::small) {
  match::Leg match(test_support::short_setup(seed, 8.0, league));
  auto blue = test_support::ball_hunter();
  auto yellow = test_support::random_team(seed);
  replay::StateTrace trace;
  while (!match.is_over()) {
    match.advance(blue, yellow);
    trace.add(match);
  }
  MatchRecord record;
  record.software = this_software();
  record.isolation = "none";
  record.teams = {TeamInfo{"hunters", TeamKind::plugin, std::string(64, 'a')},
                  TeamInfo{"\"random\" <b>", TeamKind::dds, std::nullopt}};
  record.teams[0].parameters = {{"wait", 0.4}};
  record.budget[0] = {.cpu_seconds = 1.25,
                      .slowest_tick_ms = 3.5,
                      .bank_seconds = 2.75,
                      .late_ticks = 2,
                      .bad_commands = 7};
  record.recording = replay::record(match, trace);
  return record;
}

class Leagues : public testing::TestWithParam<League> {};
INSTANTIATE_TEST_SUITE_P(All, Leagues,
                         testing::Values(League::small, League::middle, League::large));

TEST_P(Leagues, RecordsReadBackAsWrittenAndVerify) {
  MemoryFiles files;
  const MatchRecord record = played(3, GetParam());
  ASSERT_TRUE(save(files, "leg.json", record));
  const auto loaded = load(files, "leg.json");
  ASSERT_TRUE(test_support::is_ok(loaded));
  EXPECT_EQ(to_json(*loaded), to_json(record));
  EXPECT_EQ(loaded->recording.trace.ticks, record.recording.trace.ticks);
  EXPECT_EQ(loaded->recording.trace.checkpoints.size(), record.recording.trace.checkpoints.size());
  EXPECT_FALSE(replay::verify(loaded->recording));
}

// Catches a field that is written under another key, or read from one, than its own.
TEST(MatchRecord, ReadsBackEveryFieldOfABudget) {
  MemoryFiles files;
  ASSERT_TRUE(save(files, "leg.json", played(1)));
  const Json written = Json::parse(*files.read("leg.json"))["budget"]["blue"];
  EXPECT_EQ(written["cpu_seconds"], 1.25);
  EXPECT_EQ(written["slowest_tick_ms"], 3.5);
  EXPECT_EQ(written["bank_seconds"], 2.75);
  EXPECT_EQ(written["late_ticks"], 2);
  EXPECT_EQ(written["bad_commands"], 7);
  EXPECT_EQ(written.size(), 5u);
  const auto loaded = load(files, "leg.json");
  ASSERT_TRUE(test_support::is_ok(loaded));
  const BudgetReport& read = loaded->budget[0];
  EXPECT_EQ(read.cpu_seconds, 1.25);
  EXPECT_EQ(read.slowest_tick_ms, 3.5);
  EXPECT_EQ(read.bank_seconds, 2.75);
  EXPECT_EQ(read.late_ticks, 2);
  EXPECT_EQ(read.bad_commands, 7);
}

// Catches a reader that accepts values that no leg can have.
TEST(MatchRecord, NamesTheKeyThatIsWrong) {
  MemoryFiles files;
  ASSERT_TRUE(save(files, "leg.json", played(1)));
  const Json whole = Json::parse(*files.read("leg.json"));
  const auto error_with = [&](const char* pointer, const Json& value) -> std::string {
    Json changed = whole;
    changed[Json::json_pointer(pointer)] = value;
    (void)files.write("leg.json", changed.dump());
    const auto loaded = load(files, "leg.json", ChecksumPolicy::ignored);
    return loaded ? "" : loaded.error().what;
  };
  EXPECT_EQ(error_with("/seed", 7), "");
  EXPECT_EQ(error_with("/seed", -1), "leg.json: /seed: -1 is not at least 0");
  EXPECT_EQ(error_with("/control_period", 0), "leg.json: /control_period: 0 is not at least 0.001");
  EXPECT_EQ(error_with("/rules/half_s", nullptr),
            "leg.json: /rules/half_s: it is more than 36000 s");
  EXPECT_EQ(error_with("/state_hash", "x"),
            "leg.json: /state_hash: 16 hexadecimal digits are expected, not \"x\"");
  EXPECT_EQ(error_with("/decisions/0/robots/blue", Json::array({11})),
            "leg.json: /decisions/0/robots/blue/0: 11 is not at most 10");
  EXPECT_EQ(error_with("/teams/blue/kind", "human"),
            "leg.json: /teams/blue/kind: one of plugin, house, dds, firasim is expected, "
            "not \"human\"");
}

TEST(MatchRecord, HasTheKeysThatOthersRelyOn) {
  MemoryFiles files;
  ASSERT_TRUE(save(files, "leg.json", played(1)));
  const Json json = Json::parse(*files.read("leg.json"));
  EXPECT_EQ(json["schema"], "mirocup/match/1");
  for (const char* pointer : {"/software/version",
                              "/software/build",
                              "/software/game",
                              "/league",
                              "/rules/preset",
                              "/stage",
                              "/seed",
                              "/control_period",
                              "/teams/blue/name",
                              "/teams/blue/kind",
                              "/teams/blue/sha256",
                              "/teams/blue/parameters/wait",
                              "/teams/yellow/name",
                              "/result/score/blue",
                              "/result/score/yellow",
                              "/result/winner",
                              "/result/end",
                              "/result/fault",
                              "/decisions/0/tick",
                              "/decisions/0/clock",
                              "/decisions/0/law",
                              "/decisions/0/decision",
                              "/decisions/0/team",
                              "/decisions/0/reason",
                              "/decisions/0/ball/1",
                              "/decisions/0/restart",
                              "/budget/blue/cpu_seconds",
                              "/budget/blue/slowest_tick_ms",
                              "/budget/blue/late_ticks",
                              "/budget/blue/bad_commands",
                              "/isolation",
                              "/ticks",
                              "/state_hash",
                              "/replay/file",
                              "/replay/sha256",
                              "/sha256"}) {
    EXPECT_TRUE(json.contains(Json::json_pointer(pointer))) << pointer;
  }
}

TEST(MatchRecord, NamesDamage) {
  MemoryFiles files;
  ASSERT_TRUE(save(files, "leg.json", played(1)));
  const std::string record = *files.read("leg.json");
  const std::string replay = *files.read("leg.replay.zst");

  const auto problem = [&](const std::string& changed_record,
                           const std::string& changed_replay) -> Error {
    (void)files.write("leg.json", changed_record);
    (void)files.write("leg.replay.zst", changed_replay);
    const auto loaded = load(files, "leg.json");
    return loaded ? Error{Errc::input, "not found"} : loaded.error();
  };
  EXPECT_EQ(problem(record.substr(0, record.size() / 2), replay).code, Errc::damaged) << "cut off";
  EXPECT_EQ(problem(record, replay.substr(0, replay.size() - 1)).code, Errc::damaged);
  std::string flipped = replay;
  flipped[replay.size() / 2] ^= 1;
  EXPECT_EQ(problem(record, flipped).code, Errc::damaged);
  const std::string before_seal = record.substr(0, record.rfind(",\n"));
  std::string newer = before_seal;
  newer.replace(newer.find("match/1"), 7, "match/9");
  newer += ",\n \"sha256\": \"" + system::sha256(newer) + "\"\n}\n";
  const Error error = problem(newer, replay);
  EXPECT_EQ(error.code, Errc::damaged);
  EXPECT_NE(error.what.find("mirocup/match/9"), std::string::npos) << error.what;
  EXPECT_EQ(problem(record, replay).what, "not found") << "the undamaged pair";
}

TEST(MatchRecord, IsWrittenAfterItsReplayOrNotAtAll) {
  MemoryFiles files;
  files.fail_after(1);  // the replay is written, then the disk is full
  EXPECT_FALSE(save(files, "leg.json", played(1)));
  EXPECT_FALSE(files.exists("leg.json"));
}

TEST(MatchRecord, StaysSmall) {
  MemoryFiles files;
  match::Leg match(test_support::short_setup(5, 60.0, League::large));
  auto blue = test_support::random_team(1);
  auto yellow = test_support::random_team(2);
  replay::StateTrace trace;
  while (!match.is_over()) {
    match.advance(blue, yellow);
    trace.add(match);
  }
  MatchRecord record = played(1);
  record.recording = replay::record(match, trace);
  ASSERT_TRUE(save(files, "leg.json", record));
  // Two minutes of 22 robots with random commands: at most a fifth of a ten-minute leg.
  EXPECT_LT(files.read("leg.replay.zst")->size(), 400'000u);
  EXPECT_LT(files.read("leg.json")->size(), 20'000u);
}

}  // namespace
}  // namespace mirocup::record
