// SPDX-License-Identifier: MIT
//
// Runs mirocup rerun as its users do. Catches a rerun that does not find a team whose commands
// depend on other inputs than its observations.
#include "tests/support/program.hpp"

#include <gtest/gtest.h>

#include <filesystem>

namespace mirocup {
namespace {

using namespace test_support;

std::string library(const std::string& name) {
  return program("house/" + name + ".so");
}

Outcome play(const std::string& blue, const std::string& yellow, const std::string& record) {
  return run_mirocup(
      {"match", "--blue", blue, "--yellow", yellow, "--half", "15", "--record", record});
}

Outcome rerun(const std::string& record, const std::vector<std::string>& more = {}) {
  std::vector<std::string> words{program("mirocup"), "rerun", record, "--json"};
  words.insert(words.end(), more.begin(), more.end());
  return run(words);
}

TEST(RerunCommand, FindsTheLibraryByItsDigest) {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder / "entries/a/1");
  std::filesystem::create_directories(folder / "records");
  std::filesystem::copy_file(library("keeper"), folder / "entries/a/1/strategy.so");
  ASSERT_EQ(
      play(folder / "entries/a/1/strategy.so", "chaser", folder / "records/leg.json").exit_code, 0);
  EXPECT_EQ(rerun(folder / "records/leg.json").exit_code, 0) << "as in a league";
  EXPECT_EQ(rerun(folder / "records/leg.json", {"--entries", folder / "entries"}).exit_code, 0);
  EXPECT_EQ(rerun(folder / "records/leg.json", {"--entries", folder / "records"}).exit_code, 3);
}

TEST(RerunCommand, NamesTheTeamWhoseCommandsDiffer) {
  const TemporaryFolder folder;
  ASSERT_EQ(play("striker", program("teams/moody.so"), folder / "leg.json").exit_code, 0);
  const Outcome again = expect_exit(1, rerun(folder / "leg.json", {"--entries", program("teams")}));
  const auto answer = nlohmann::json::parse(again.out);
  EXPECT_EQ(answer["team"], "yellow");
  EXPECT_EQ(answer["tick"], 40) << "the first tick in which it looks at the time";
}

TEST(RerunCommand, ReproducesAForfeit) {
  const TemporaryFolder folder;
  ASSERT_EQ(play("striker", program("teams/gives_up.so"), folder / "leg.json").exit_code, 0);
  ASSERT_EQ(read_json(folder / "leg.json")["result"]["end"], "forfeit");
  expect_exit(0, rerun(folder / "leg.json", {"--entries", program("teams")}));
}

// Catches a rerun that gives the teams other parameters than the record says.
TEST(RerunCommand, GivesTheTeamsTheirParametersAgain) {
  const TemporaryFolder folder;
  ASSERT_EQ(
      run_mirocup({"match", "--blue", "chaser", "--yellow", program("teams/tuned.so"), "--half",
                   "5", "--yellow-param", "speed=9.5", "--record", folder / "leg.json"})
          .exit_code,
      0);
  expect_exit(0, rerun(folder / "leg.json", {"--entries", program("teams")}));
}

}  // namespace
}  // namespace mirocup
