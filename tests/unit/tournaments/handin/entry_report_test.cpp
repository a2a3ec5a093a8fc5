// SPDX-License-Identifier: MIT
#include "tournaments/handin/entry_report.hpp"

#include "system/files.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace mirocup::league {
namespace {

struct Answer {
  test_support::TemporaryFolder temporary;
  system::Disk disk;
  Folder folder{temporary / "league"};

  Json with(const std::string& verdict, HandInState state, const std::string& message,
            int plays = 0) {
    EXPECT_TRUE(disk.make_folder(folder.entry("a", 1)) &&
                disk.write(folder.verdict("a", 1), verdict));
    return *entry_report(disk, folder,
                         {.team = "a",
                          .entry = 1,
                          .is_network = true,
                          .state = state,
                          .message = message,
                          .plays = plays,
                          .library = "hash"},
                         0, {}, false);
  }
};

// Catches an answer that takes the end of an advice for what plays on.
TEST(EntryReport, TellsARefusalInFourLines) {
  const std::string verdict = R"({"accepted": false,
    "reason": "ticks: it threw: catch it; gdb stops",
    "checks": [{"name": "ticks", "what": "it threw", "where": "tick 3",
                "cure": "catch it; gdb stops"}],
    "legs": [{"colour": "blue", "opponent": "striker", "score": [3, 1]}]})";
  const std::string message = "a: entry 1 was not accepted: ticks: it threw: catch it; gdb stops";
  EXPECT_EQ(Answer().with(verdict, HandInState::refused, message)["told"],
            (Json{"What: it threw", "Where: tick 3", "Do: catch it; gdb stops",
                  "Plays: nothing changes"}));
  const Json after = Answer().with(verdict, HandInState::refused, message, 4);
  EXPECT_EQ(after["told"][3], "Plays: entry 4 plays on");
  EXPECT_EQ(after["plays"], "entry 4 plays on");
  EXPECT_EQ(Answer().with(R"({"accepted": false})", HandInState::refused,
                          "a: not taken; entry 7 plays on")["plays"],
            "nothing changes")
      << "what plays is not read from the sentence";
}

// Catches an answer that reads the scores from sentences, and one that fails at a damaged verdict.
TEST(EntryReport, TellsTheScoresOfAnAcceptedEntry) {
  const Json report = Answer().with(
      R"({"accepted": true, "checks": [], "legs": [
        {"colour": "blue", "opponent": "striker", "score": [3, 1], "own_goals": 0},
        {"colour": "yellow", "opponent": "striker", "score": [0, 2], "own_goals": 1},
        {"score": [1]}]})",
      HandInState::accepted, "a: entry 1 was accepted");
  EXPECT_EQ(report["told"], (Json{"3 : 1 against striker as blue",
                                  "0 : 2 against striker as yellow, own goals: 1"}));
  EXPECT_FALSE(report.contains("plays"));
}

}  // namespace
}  // namespace mirocup::league
