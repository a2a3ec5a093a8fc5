// SPDX-License-Identifier: MIT
//
// Catches a record that differs from the leg, and one that reads back differently. Damage is in
// damage_test.cpp, the keys in tests/programs/records.
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

MatchRecord played(std::uint64_t seed, RobotLeague league = RobotLeague::small) {
  match::Leg match(test_support::short_setup(seed, 8.0, league));
  auto blue = test_support::ball_hunter();
  auto yellow = test_support::random_team(seed);
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
  record.recording = test_support::played_and_traced(match, blue, yellow);
  return record;
}

class Leagues : public testing::TestWithParam<RobotLeague> {};
INSTANTIATE_TEST_SUITE_P(All, Leagues,
                         testing::Values(RobotLeague::small, RobotLeague::middle,
                                         RobotLeague::large));

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

// Catches a number that is written and read under the key of another one.
TEST(MatchRecord, HasTheNumbersOfABudgetUnderTheirKeys) {
  MemoryFiles files;
  ASSERT_TRUE(save(files, "leg.json", played(1)));
  const Json expected = {{"cpu_seconds", 1.25},
                         {"slowest_tick_ms", 3.5},
                         {"bank_seconds", 2.75},
                         {"late_ticks", 2},
                         {"bad_commands", 7}};
  EXPECT_EQ(Json::parse(*files.read("leg.json"))["budget"]["blue"], expected);
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
    return test_support::why_not(load(files, "leg.json", ChecksumPolicy::ignored));
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

TEST(MatchRecord, NamesTheSchemaThatItCannotRead) {
  MemoryFiles files;
  ASSERT_TRUE(save(files, "leg.json", played(1)));
  std::string newer = *files.read("leg.json");
  newer.resize(newer.rfind(",\n"));  // before the checksum
  newer.replace(newer.find("match/1"), 7, "match/9");
  newer += ",\n \"sha256\": \"" + system::sha256(newer) + "\"\n}\n";
  ASSERT_TRUE(files.write("leg.json", newer));
  const auto loaded = load(files, "leg.json");
  ASSERT_FALSE(loaded);
  EXPECT_EQ(loaded.error().code, Errc::damaged);
  EXPECT_NE(loaded.error().what.find("mirocup/match/9"), std::string::npos) << loaded.error().what;
}

TEST(MatchRecord, IsWrittenAfterItsReplayOrNotAtAll) {
  MemoryFiles files;
  files.fail_after(1);  // the replay is written, then the disk is full
  EXPECT_FALSE(save(files, "leg.json", played(1)));
  EXPECT_FALSE(files.exists("leg.json"));
}

TEST(MatchRecord, StaysSmall) {
  MemoryFiles files;
  match::Leg match(test_support::short_setup(5, 60.0, RobotLeague::large));
  auto blue = test_support::random_team(1);
  auto yellow = test_support::random_team(2);
  MatchRecord record = played(1);
  record.recording = test_support::played_and_traced(match, blue, yellow);
  ASSERT_TRUE(save(files, "leg.json", record));
  // Two minutes of 22 robots with random commands: at most a fifth of a ten-minute leg.
  EXPECT_LT(files.read("leg.replay.zst")->size(), 400'000u);
  EXPECT_LT(files.read("leg.json")->size(), 20'000u);
}

}  // namespace
}  // namespace mirocup::record
