// SPDX-License-Identifier: MIT
//
// Catches a league that goes on with a program that plays otherwise.
#include "tournaments/play/program.hpp"

#include "tests/support/is_ok.hpp"
#include "tests/support/memory_files.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/unit/tournaments/small_league.hpp"

#include <gtest/gtest.h>

namespace mirocup::league {
namespace {

// Starts a league with a program and goes on with this one. Returns why it may not; "" if it may.
std::string refusal(const std::string& version, const std::string& game) {
  test_support::MemoryFiles files;
  const test_support::TemporaryFolder temporary;  // for its lock
  const Folder folder{temporary / "."};
  EXPECT_TRUE(files.write(folder.config(), print_league_file(league_file_of({"a", "b"}))));
  auto store = LeagueStore::open(files, folder);
  EXPECT_TRUE(test_support::is_ok(store));
  Started start = start_of(files, folder);
  start.version = version;
  start.game = game;
  EXPECT_TRUE(store->write(start));
  return test_support::why_not(
      expect_program(*store, {.version = "0.1.2", .build = "g++", .behaviour_hash = "beef"}));
}

TEST(Program, IsOfTheVersionInTheJournal) {
  EXPECT_EQ(refusal("0.1.2", "beef"), "");
  EXPECT_EQ(refusal("0.1.0", "beef"), "") << "a fix of the same minor version plays the same legs";
  const std::string other_game = refusal("0.1.2", "f00d");
  EXPECT_NE(other_game.find("is played with mirocup 0.1.2 (game f00d); this program is mirocup "
                            "0.1.2 (game beef), which may play other legs from the same seeds. "
                            "Continue with mirocup 0.1.2 (game f00d)"),
            std::string::npos)
      << other_game;
  const std::string other_version = refusal("0.2.0", "beef");
  EXPECT_NE(other_version.find("Continue with mirocup 0.2.0 (game beef), or a fix of it"),
            std::string::npos)
      << other_version;
}

}  // namespace
}  // namespace mirocup::league
