// SPDX-License-Identifier: MIT
//
// Files that were made to harm who reads them. Catches a program that crashes, or that ends without
// a sentence and the exit code for a wrong or a damaged file.
#include "tests/support/program.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>

namespace mirocup {
namespace {

using namespace test_support;

// Lists within each other, 200 000 deep: they ended the programs by SIGSEGV.
std::string deep() {
  return std::string(200'000, '[') + std::string(200'000, ']');
}

void expect_sentence(const Outcome& outcome, int exit_code, const std::string& file) {
  EXPECT_EQ(outcome.exit_code, exit_code) << outcome.err.substr(0, 1000);
  EXPECT_NE(outcome.err.find(file), std::string::npos) << outcome.err.substr(0, 1000);
  EXPECT_EQ(outcome.err.find("exception"), std::string::npos) << outcome.err.substr(0, 1000);
  EXPECT_LT(outcome.err.size(), 1500u);
}

// Catches a leg that a source or an archive loses by 0 : 10: its owner named the wrong file.
TEST(StrangeFiles, AreNoTeamOfAMatch) {
  const TemporaryFolder folder;
  for (const auto& [name, text] :
       {std::pair("team.cpp", "#include <cmath>\n"), std::pair("team.rar", "Rar!\x1a\x07\x01"),
        std::pair("README.md", "# Mine\n\n```\nx\n```\n")}) {
    write_file(folder / name, text);
    expect_sentence(run_mirocup({"match", "--blue", folder / name, "--yellow", "idle"}), 2, name);
  }
}

TEST(StrangeFiles, MakeAJournalDamaged) {
  const TemporaryFolder folder;
  const std::string mirocup = program("mirocup");
  const std::string league = folder / "l";
  ASSERT_EQ(
      run({mirocup, "league", "init", league, "--team", "a=house:idle", "--team", "b=house:idle"})
          .exit_code,
      0);
  write_file(league + "/journal.jsonl", "{\"n\":1,\"kind\":" + deep() + "}\n");
  expect_sentence(run({mirocup, "league", "status", league}), 4, "journal.jsonl: line 1");
}

// Catches an exception where the answer has a path whose name is not UTF-8.
TEST(StrangeFiles, MayHaveNamesThatAreNotUtf8) {
  const TemporaryFolder folder;
  const std::string mirocup = program("mirocup");
  const std::string record = folder / "leg\xff.json";
  ASSERT_EQ(run({mirocup, "match", "--blue", "idle", "--yellow", "idle", "--half", "1", "--record",
                 record})
                .exit_code,
            0);
  for (const std::vector<std::string>& command :
       {std::vector<std::string>{mirocup, "verify", record, "--json"},
        std::vector<std::string>{mirocup, "referee", "--record", record, "--json"}}) {
    const Outcome outcome = run(command);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_TRUE(nlohmann::json::accept(outcome.out)) << outcome.out;
  }
}

// A ball on its way for years, wheels that hold a billionth of the weight or any force, a rolling
// resistance that is linear below a nanometre per second, and robots of 20 nm did not end. A row
// of robots that is hit at 1e5 m/s overlapped.
TEST(StrangeFiles, AreScenesThatEnd) {
  const TemporaryFolder folder;
  const std::string file = folder / "s.json";
  for (const char* scene :
       {R"("duration":1e9)", R"("duration":1,"parameters":{"grip":1e-9})",
        R"("duration":1,"parameters":{"grip":0})", R"("duration":1,"parameters":{"grip":1e300})",
        R"("duration":1,"parameters":{"k":1e-9})",
        R"("duration":1,"parameters":{"robot_side":2e-8})",
        R"("duration":1,"robots":[{"pose":[0,0,0],"twist":[1e5,0,0]}])"}) {
    write_file(file, std::string("{\"schema\":\"mirocup/scene/1\",") + scene + "}");
    expect_sentence(run_mirocup({"scene", file}), 2, file);
  }
}

}  // namespace
}  // namespace mirocup
