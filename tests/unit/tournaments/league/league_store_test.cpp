// SPDX-License-Identifier: MIT
//
// Catches a state that differs from its journal: after an event that is refused, after a disk that
// fails, after an event of another process.
#include "tournaments/league/league_store.hpp"

#include "tests/support/is_ok.hpp"
#include "tests/support/memory_files.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/unit/tournaments/small_league.hpp"

#include <gtest/gtest.h>

namespace mirocup::league {
namespace {

// The files are in memory; the folder is real, because locks are.
class LeagueStoreTest : public testing::Test {
 protected:
  LeagueStoreTest() {
    EXPECT_TRUE(files_.write(folder_.config(), print_league_file(league_file_of({"a", "b"}))));
  }

  LeagueStore open() {
    auto store = LeagueStore::open(files_, folder_);
    EXPECT_TRUE(test_support::is_ok(store));
    return std::move(*store);
  }

  Started start_event() { return start_of(files_, folder_); }

  test_support::MemoryFiles files_;
  const test_support::TemporaryFolder temporary_;
  const Folder folder_{temporary_ / "."};
};

TEST_F(LeagueStoreTest, WritesNothingThatDoesNotFit) {
  LeagueStore store = open();
  EXPECT_FALSE(store.write(Paused{.team = "a", .signature = {"w"}})) << "it has not started";
  EXPECT_EQ(store.lines(), 0u);
  EXPECT_FALSE(files_.exists(folder_.journal()));
  ASSERT_TRUE(store.write(start_event()));
  EXPECT_TRUE(store.state().is_started);
  EXPECT_EQ(store.lines(), 1u);
}

TEST_F(LeagueStoreTest, StaysAsItWasWhenTheDiskFails) {
  LeagueStore store = open();
  files_.fail_after(0);
  EXPECT_FALSE(store.write(start_event()));
  EXPECT_FALSE(store.state().is_started);
  EXPECT_EQ(store.lines(), 0u);
}

TEST_F(LeagueStoreTest, AppliesTheEventsOfOthersBeforeItsOwn) {
  LeagueStore one = open();
  LeagueStore other = open();
  ASSERT_TRUE(one.write(start_event()));
  ASSERT_TRUE(one.write(Paused{.team = "a", .signature = {"w"}}));
  EXPECT_FALSE(other.write(Paused{.team = "a", .signature = {"w"}})) << "is paused already";
  EXPECT_EQ(other.state().teams[0].status, TeamStatus::paused);
  EXPECT_EQ(other.lines(), 2u);
}

// Catches a team that joined twice because the state was made again from the journal.
TEST_F(LeagueStoreTest, KeepsATeamThatJoinedWhenADecisionIsUndone) {
  const LeagueFile file = league_file_of({"a", "b"}, {.kind = FormatKind::nightly}, "submitted");
  ASSERT_TRUE(files_.write(folder_.config(), print_league_file(file)));
  LeagueStore store = open();
  ASSERT_TRUE(store.write(start_event()));
  ASSERT_TRUE(store.write(TeamJoined{.team = "c", .source = "submitted"}));
  ASSERT_TRUE(store.write(Paused{.team = "c", .signature = {"w", "H"}}));
  ASSERT_TRUE(store.write(Undone{.line = 3, .signature = {"w", "H"}}));
  for (const LeagueState& state : {store.state(), open().state()}) {
    ASSERT_EQ(state.teams.size(), 3u);
    EXPECT_EQ(state.file.teams.size(), 3u);
    EXPECT_EQ(state.teams[2].status, TeamStatus::playing);
  }
}

}  // namespace
}  // namespace mirocup::league
