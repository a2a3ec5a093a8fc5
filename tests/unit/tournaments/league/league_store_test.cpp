// SPDX-License-Identifier: MIT
//
// Catches a state that differs from its journal: after an event that is refused, after a disk that
// fails, after an event of another process.
#include "tournaments/league/league_store.hpp"

#include "system/digest.hpp"
#include "tests/support/is_ok.hpp"
#include "tests/support/memory_files.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <unistd.h>

namespace mirocup::league {
namespace {

// The files are in memory; the folder is real, because locks are.
class LeagueStoreTest : public testing::Test {
 protected:
  LeagueStoreTest() {
    std::filesystem::create_directories(folder_.path);
    LeagueFile file;
    for (const char* name : {"a", "b"}) {
      file.teams.push_back({.name = name, .source = "house:idle", .over_dds = false});
    }
    EXPECT_TRUE(files_.write(folder_.config(), print_league_file(file)));
  }
  ~LeagueStoreTest() override { std::filesystem::remove_all(folder_.path); }

  LeagueStore open() {
    auto store = LeagueStore::open(files_, folder_);
    EXPECT_TRUE(test_support::is_ok(store));
    return std::move(*store);
  }

  Started start_event() {
    return {.config_sha256 = system::sha256(*files_.read(folder_.config())), .version = "0"};
  }

  test_support::MemoryFiles files_;
  const Folder folder_{testing::TempDir() + "league_store_test-" + std::to_string(getpid())};
};

TEST_F(LeagueStoreTest, WritesNothingThatDoesNotFit) {
  LeagueStore store = open();
  EXPECT_FALSE(store.write(Paused{.team = "a", .why = "w", .by = {}})) << "it has not started";
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
  ASSERT_TRUE(one.write(Paused{.team = "a", .why = "w", .by = {}}));
  EXPECT_FALSE(other.write(Paused{.team = "a", .why = "w", .by = {}})) << "is paused already";
  EXPECT_EQ(other.state().teams[0].status, TeamStatus::paused);
  EXPECT_EQ(other.lines(), 2u);
}

// Catches a team that joined twice because the state was made again from the journal.
TEST_F(LeagueStoreTest, KeepsATeamThatJoinedWhenADecisionIsUndone) {
  LeagueFile file;
  file.format.kind = FormatKind::nightly;
  for (const char* name : {"a", "b"}) file.teams.push_back({.name = name, .source = "submitted"});
  ASSERT_TRUE(files_.write(folder_.config(), print_league_file(file)));
  LeagueStore store = open();
  ASSERT_TRUE(store.write(start_event()));
  ASSERT_TRUE(store.write(TeamJoined{.team = "c", .source = "submitted"}));
  ASSERT_TRUE(store.write(Paused{.team = "c", .why = "w", .by = "H"}));
  ASSERT_TRUE(store.write(Undone{.line = 3, .why = "w", .by = "H"}));
  for (const LeagueState& state : {store.state(), open().state()}) {
    ASSERT_EQ(state.teams.size(), 3u);
    EXPECT_EQ(state.file.teams.size(), 3u);
    EXPECT_EQ(state.teams[2].status, TeamStatus::playing);
  }
}

TEST_F(LeagueStoreTest, RefusesALeagueFileThatChangedAfterTheStart) {
  ASSERT_TRUE(open().write(start_event()));
  LeagueFile changed;
  changed.seed = 2;
  ASSERT_TRUE(files_.write(folder_.config(), print_league_file(changed)));
  const auto store = LeagueStore::open(files_, folder_);
  ASSERT_FALSE(store);
  EXPECT_EQ(store.error().code, Errc::input);
  EXPECT_NE(store.error().what.find("changed after the league started"), std::string::npos);
}

}  // namespace
}  // namespace mirocup::league
