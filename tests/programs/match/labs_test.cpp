// SPDX-License-Identifier: MIT
//
// The commands of mirocup-labs in a build without it.
#include "tests/support/program.hpp"

#include <gtest/gtest.h>

#include <filesystem>

namespace mirocup {
namespace {

using namespace test_support;

// Catches a command that vanishes with mirocup-labs, and an answer that does not say how to get it.
TEST(WithoutLabs, CommandsSayWhatBuildsThem) {
  const TemporaryFolder folder;
  const std::string alone = folder / "mirocup";
  std::filesystem::copy_file(program("mirocup"), alone);
  const std::string help = run({alone, "--help"}).out;
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"bench", "--quick"},
        {"export", "p.npz", "-o", "p.cpp"},
        {"identify", "seen.jsonl", "-o", "ours.json"},
        {"record-as-seen", "leg.json", "-o", "seen.jsonl"},
        {"tune", "mine.so", "--param", "wait=0:1", "--against", "chaser"},
        {"validate", "seen.jsonl"},
        {"new", folder / "mine", "--from-simurosot", "old"}}) {
    EXPECT_TRUE(contains(help, "\n  " + words[0] + " ")) << words[0];
    std::vector<std::string> command{alone};
    command.insert(command.end(), words.begin(), words.end());
    const auto outcome = run(command);
    EXPECT_EQ(outcome.exit_code, 3) << words[0];
    EXPECT_EQ(outcome.out, "") << words[0];
    EXPECT_TRUE(contains(outcome.err, "--target mirocup-labs"));
  }
  EXPECT_FALSE(std::filesystem::exists(folder / "mine"));
}

}  // namespace
}  // namespace mirocup
