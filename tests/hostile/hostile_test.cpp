// SPDX-License-Identifier: MIT
//
// What a team does wrong costs that team, whatever its colour; the other one and the server go on,
// and the record says why.
#include "tests/support/program.hpp"

#include <gtest/gtest.h>

namespace mirocup {
namespace {

using test_support::Outcome;
using test_support::program;
using test_support::read_json;
using test_support::run;
using test_support::TemporaryFolder;

std::string hostile(const std::string& name) {
  return program("hostile/" + name + ".so");
}

struct Case {
  std::string name;
  std::string code;  // of the fault
  std::string text;  // part of its sentence
};

class Hostile : public testing::TestWithParam<Case> {};
INSTANTIATE_TEST_SUITE_P(Teams, Hostile,
                         testing::Values(Case{"crash", "crash", "signal"},
                                         Case{"hang", "hang", "processor time"},
                                         Case{"leaves", "crash", "exit code 0"},
                                         Case{"throws", "crash", "thrown on purpose"},
                                         Case{"other_version", "bad_abi", "version 2"},
                                         Case{"no_entry", "bad_abi", "mirocup_entry"}),
                         [](const auto& c) { return c.param.name; });

TEST_P(Hostile, LosesTheLegAndTheRecordSaysWhy) {
  const TemporaryFolder folder;
  for (const std::string colour : {"blue", "yellow"}) {
    const std::string other = colour == "blue" ? "yellow" : "blue";
    const Outcome played =
        run({program("mirocup"), "match", "--" + colour, hostile(GetParam().name), "--" + other,
             "chaser", "--half", "2", "--record", folder / "leg.json"});
    EXPECT_EQ(played.exit_code, 0) << played.err;
    const auto record = read_json(folder / "leg.json");
    EXPECT_EQ(record["result"]["end"], "forfeit");
    EXPECT_EQ(record["result"]["winner"], other);
    EXPECT_EQ(record["result"]["score"][other], 10);
    EXPECT_EQ(record["result"]["fault"]["team"], colour);
    EXPECT_EQ(record["result"]["fault"]["code"], GetParam().code);
    const std::string text = record["result"]["fault"]["text"];
    EXPECT_NE(text.find(GetParam().text), std::string::npos) << text;
    EXPECT_EQ(run({program("mirocup"), "verify", folder / "leg.json"}).exit_code, 0);
  }
}

TEST(HostileTeam, ThatAnswersNonsenseDrivesWithZeros) {
  const TemporaryFolder folder;
  run({program("mirocup"), "match", "--blue", hostile("not_a_number"), "--yellow", "chaser",
       "--half", "2", "--record", folder / "leg.json"});
  const auto record = read_json(folder / "leg.json");
  EXPECT_EQ(record["result"]["end"], "full_time");
  EXPECT_GT(record["budget"]["blue"]["bad_commands"], 50);
  EXPECT_EQ(record["budget"]["yellow"]["bad_commands"], 0);
}

TEST(HostileTeam, OfBothColoursLosesForBoth) {
  const TemporaryFolder folder;
  run({program("mirocup"), "match", "--blue", hostile("crash"), "--yellow", hostile("crash"),
       "--half", "2", "--record", folder / "leg.json"});
  const auto record = read_json(folder / "leg.json");
  EXPECT_EQ(record["result"]["end"], "double_forfeit");
  EXPECT_TRUE(record["result"]["winner"].is_null());
}

TEST(HostileTeam, ThatTalksIsHeardUpToALimit) {
  const TemporaryFolder folder;
  run({program("mirocup"), "match", "--blue", hostile("talks"), "--yellow", "idle", "--half", "2",
       "--record", folder / "leg.json"});
  const std::string log = test_support::read_file(folder / "leg.json.blue.log");
  EXPECT_EQ(log.rfind("a line that nobody asked for, 0\n", 0), 0u);
  EXPECT_LE(log.size(), 65536u);
  EXPECT_EQ(read_json(folder / "leg.json")["result"]["end"], "full_time");
}

TEST(HostileTeam, ThatIsNoLibraryDoesNotLoad) {
  const TemporaryFolder folder;
  test_support::write_file(folder / "text.so", "not a library\n");
  const Outcome played = run({program("mirocup"), "match", "--blue", folder / "text.so", "--yellow",
                              "idle", "--half", "1", "--record", folder / "leg.json"});
  EXPECT_EQ(played.exit_code, 0);
  EXPECT_EQ(read_json(folder / "leg.json")["result"]["fault"]["code"], "no_load");
}

TEST(HostileTeam, InTheServersOwnProcessAtLeastMayThrow) {
  const TemporaryFolder folder;
  const Outcome played = run({program("mirocup"), "match", "--trusted", "--blue", hostile("throws"),
                              "--yellow", "idle", "--half", "2", "--record", folder / "leg.json"});
  EXPECT_EQ(played.exit_code, 0);
  const auto record = read_json(folder / "leg.json");
  EXPECT_EQ(record["result"]["fault"]["code"], "crash");
  EXPECT_EQ(record["isolation"], "none");
}

}  // namespace
}  // namespace mirocup
