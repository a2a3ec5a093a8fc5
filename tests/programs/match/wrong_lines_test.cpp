// SPDX-License-Identifier: MIT
//
// Wrong command lines, one a line of wrong_lines.txt. Catches an answer with another exit code,
// with more than one sentence, with words of a library that a user does not know, or with something
// on standard output.
#include "tests/support/program.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <sstream>

namespace mirocup {
namespace {

using namespace test_support;

std::vector<std::string> words_in(const std::string& text) {
  std::istringstream in(text);
  std::vector<std::string> words;
  for (std::string word; in >> word;) words.push_back(word);
  return words;
}

TEST(WrongLines, AreAnsweredWithOneSentenceThatSaysWhatToType) {
  std::istringstream lines(
      read_file(MIROCUP_SOURCE_FOLDER "/tests/programs/match/wrong_lines.txt"));
  int count = 0;
  for (std::string line; std::getline(lines, line);) {
    if (line.empty() || line[0] == '#') continue;
    std::istringstream columns(line);
    std::string code, arguments, sentence;
    std::getline(columns, code, '\t');
    std::getline(columns, arguments, '\t');
    std::getline(columns, sentence);
    std::vector<std::string> words = words_in(arguments);
    words.insert(words.begin(), program("mirocup"));
    const auto outcome = run(words);
    EXPECT_EQ(outcome.exit_code, std::stoi(code)) << arguments;
    EXPECT_EQ(outcome.out, "") << arguments;
    EXPECT_TRUE(contains(outcome.err, sentence)) << arguments;
    EXPECT_EQ(outcome.err.rfind("mirocup", 0), 0u) << arguments << '\n' << outcome.err;
    // A second line only says where to read on.
    const auto ends = std::count(outcome.err.begin(), outcome.err.end(), '\n');
    EXPECT_LE(ends, outcome.err.find("\nSee mirocup") == std::string::npos ? 1 : 2) << arguments;
    for (const char* foreign : {"exception", "[json", "terminate", "std::", "CLI::", "TEXT"})
      EXPECT_FALSE(contains(outcome.err, foreign)) << arguments;
    ++count;
  }
  EXPECT_GE(count, 100);
}

// Catches an option of any command that takes NaN, infinity, or a number as people do not write it.
TEST(WrongLines, NoOptionTakesForANumberWhatIsNone) {
  const std::set<std::string> numbers{"SECONDS", "NUMBER", "SEED", "TICK", "MARKS", "MM",
                                      "DEGREES", "SHARE",  "ELO",  "DAYS", "NIGHT", "K|auto"};
  const TemporaryFolder folder;
  for (const char* name : {"mirocup", "mirocup-league"})
    EXPECT_EQ(run({program(name), "man", folder / ""}).exit_code, 0);
  int options = 0;
  for (const auto& page : std::filesystem::directory_iterator(folder / "")) {
    std::string command = page.path().stem().string();
    const bool is_of_league = command.starts_with("mirocup-league-");
    command.erase(0, std::string(is_of_league ? "mirocup-league-" : "mirocup-").size());
    std::istringstream lines(read_file(page.path()));
    for (std::string line; std::getline(lines, line);) {
      std::erase(line, '\\');
      const std::vector<std::string> parts =
          words_in(line);  // "-o,--option", "NUMBER", "Its", "help"
      if (parts.size() < 2 || !parts[0].starts_with('-') || !numbers.contains(parts[1])) continue;
      const std::string option = parts[0].substr(parts[0].find("--"));
      ++options;
      for (const char* wrong : {"nan", "-inf", "1e999", "0x1p3", " 5"}) {
        std::vector<std::string> words{program("mirocup")};
        if (is_of_league) words.emplace_back("league");
        words.insert(words.end(), {command, option + "=" + wrong});
        const auto told = run(words);
        EXPECT_EQ(told.exit_code, 2) << command << ' ' << option << ' ' << wrong;
        EXPECT_TRUE(contains(told.err, ": " + option)) << command;
        EXPECT_FALSE(contains(told.err, "missing")) << command;
      }
    }
  }
  EXPECT_GE(options, 30);
}

// Catches the help of a whole program where that of one of its commands was asked for.
TEST(WrongLines, HelpExplainsACommandOfALeague) {
  const auto help = [](std::vector<std::string> words) {
    words.insert(words.begin(), {program("mirocup"), "help"});
    return run(words).out;
  };
  EXPECT_TRUE(contains(help({"league", "status"}), "mirocup league status [OPTIONS] DIR"));
  EXPECT_TRUE(contains(help({"league"}), "mirocup league [OPTIONS] COMMAND"));
  EXPECT_TRUE(contains(help({"match"}), "mirocup match [OPTIONS]"));
}

// Catches a completion that does not know a command, a value or a house team, and a page of the
// manual that is missing.
TEST(WrongLines, CompletionAndManualKnowWhatTheHelpKnows) {
  const auto asked = [](std::vector<std::string> words) {
    words.insert(words.begin(), {program("mirocup"), "complete"});
    return run(words).out;
  };
  EXPECT_TRUE(contains(asked({"ma"}), "match\t"));
  EXPECT_TRUE(contains(asked({"match", "--league", "m"}), "middle\t"));
  EXPECT_FALSE(contains(asked({"match", "--league", "m"}), "small"));
  const std::string teams = asked({"match", "--blue", ""});
  EXPECT_TRUE(contains(teams, "striker\t"));
  EXPECT_TRUE(contains(teams, ":files"));
  EXPECT_TRUE(contains(asked({"replay", "--o"}), "--open\t"));
  EXPECT_TRUE(contains(asked({"league", "st"}), "start\t"));
  EXPECT_TRUE(contains(asked({"league", "start", "--engine", ""}), "slurm\t"));
  EXPECT_TRUE(contains(asked({"verify", ""}), ":files"));

  const TemporaryFolder folder;
  EXPECT_EQ(
      run({"/usr/bin/env", "SOURCE_DATE_EPOCH=1000000000", program("mirocup"), "man", folder / ""})
          .exit_code,
      0);
  const std::string page = read_file(folder / "mirocup-match.1");
  for (const char* part : {".TH mirocup-match 1 2001-09-09 ", "\\-\\-league", "Examples:"})
    EXPECT_TRUE(contains(page, part)) << part;
  if (!std::filesystem::exists("/usr/bin/mandoc")) return;
  for (const auto& entry : std::filesystem::directory_iterator(folder / "")) {
    const auto said = run({"/usr/bin/mandoc", "-Tlint", "-Wwarning", entry.path()});
    EXPECT_EQ(said.exit_code, 0) << said.out << said.err;
  }
}

}  // namespace
}  // namespace mirocup
