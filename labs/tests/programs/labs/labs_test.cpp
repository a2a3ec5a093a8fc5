// SPDX-License-Identifier: MIT
//
// The commands of mirocup-labs as people call them, through `mirocup`.
#include "tests/support/program.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

namespace mirocup {
namespace {

using test_support::program;
using test_support::run;

// Catches a command that `mirocup` does not hand on, or that mirocup-labs does not know.
TEST(Labs, EachCommandHasItsHelp) {
  for (const auto& [name, option] :
       std::initializer_list<std::pair<const char*, const char*>>{{"export", "--output"},
                                                                  {"tune", "--generations"},
                                                                  {"record-as-seen", "--noise-mm"},
                                                                  {"identify", "--page"},
                                                                  {"validate", "--against"}}) {
    for (const std::vector<std::string>& words :
         {std::vector<std::string>{name, "--help"}, {"help", name}}) {
      std::vector<std::string> command{program("mirocup")};
      command.insert(command.end(), words.begin(), words.end());
      const auto outcome = run(command);
      EXPECT_EQ(outcome.exit_code, 0) << name << outcome.err;
      EXPECT_NE(outcome.out.find(option), std::string::npos) << outcome.out;
      EXPECT_NE(outcome.out.find("mirocup " + std::string(name)), std::string::npos) << outcome.out;
    }
    EXPECT_NE(run({program("mirocup"), "complete", name, "--"}).out.find(option), std::string::npos)
        << name;
  }
  EXPECT_EQ(run({program("mirocup"), "league", "tune", "--help"}).exit_code, 0);
}

// Catches a page of the manual without options, and one that the package mirocup has, too.
TEST(Labs, HasPagesOfTheManual) {
  const test_support::TemporaryFolder folder;
  EXPECT_EQ(run({program("mirocup-labs"), "man", folder / ""}).exit_code, 0);
  const std::string page = test_support::read_file(folder / "mirocup-tune.1");
  EXPECT_NE(page.find("generations"), std::string::npos) << page;
  EXPECT_FALSE(std::filesystem::exists(folder / "mirocup-new.1"));
}

// As in tests/programs/match/wrong_lines.txt: exit code, words, a part of the one sentence.
TEST(Labs, WrongLinesAreAnsweredWithOneSentence) {
  const struct {
    int code;
    std::vector<std::string> words;
    const char* sentence;
  } lines[] = {
      {2,
       {"record-as-seen", "nothing.json", "-o", "seen.jsonl", "--gaps", "nan"},
       "--gaps: nan is not a number from 0 to 0.9"},
      {2,
       {"tune", "mine.so", "--against", "chaser", "--param", "wait=nan:1"},
       "--param wait=nan:1: KEY=LOW:HIGH is expected, with LOW less than HIGH"},
      {2,
       {"league", "tune", "mine.so", "--against", "chaser", "--param", "wait=0x1:0x2"},
       "--param wait=0x1:0x2: KEY=LOW:HIGH is expected, with LOW less than HIGH"},
      {2, {"tune", "mine.so", "--param"}, "--param: "},
      {2,
       {"tune", "a.so", "--against", "b.so", "--param", "k=0:1", "--half", "nan"},
       "--half: nan"},
      {3,
       {"identify", "nothing.jsonl", "-o", "/nowhere/ours.json"},
       "/nowhere/ours.json: nothing can be written into /nowhere: No such file or directory"},
      {3,
       {"identify", "nothing.jsonl", "-o", "ours.json", "--page", "/nowhere/ours.html"},
       "/nowhere/ours.html: nothing can be written into /nowhere"},
      {2,
       {"identify", "nothing.jsonl", "-o", "./nothing.jsonl"},
       "./nothing.jsonl is an input and cannot be the output as well"},
      {2, {"identify", "nothing.jsonl", "-o", "."}, ". is a folder"},
      {2,
       {"record-as-seen", "nothing.json", "-o", "./nothing.json"},
       "./nothing.json is an input and cannot be the output as well"},
      {3,
       {"record-as-seen", "nothing.json", "-o", "/nowhere/seen.jsonl"},
       "/nowhere/seen.jsonl: nothing can be written into /nowhere"},
      {2, {"export", "p.npz"}, "--output is required; for example: mirocup export"},
      {2, {"validate", "a.jsonl", "--agianst", "box2d"}, "there is no option --agianst"},
  };
  for (const auto& line : lines) {
    std::vector<std::string> words = line.words;
    words.insert(words.begin(), program("mirocup"));
    const auto outcome = run(words);
    EXPECT_EQ(outcome.exit_code, line.code) << line.sentence << '\n' << outcome.err;
    EXPECT_EQ(outcome.out, "") << line.sentence;
    EXPECT_NE(outcome.err.find(line.sentence), std::string::npos) << outcome.err;
    EXPECT_TRUE(outcome.err.starts_with("mirocup")) << outcome.err;
    const auto ends = std::count(outcome.err.begin(), outcome.err.end(), '\n');
    EXPECT_LE(ends, outcome.err.find("\nSee mirocup") == std::string::npos ? 1 : 2) << outcome.err;
  }
}

}  // namespace
}  // namespace mirocup
