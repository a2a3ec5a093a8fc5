// SPDX-License-Identifier: MIT
//
// Catches shards of fixtures that only one host can play, and of a league that has not started.
#include "tournaments/play/shard.hpp"

#include "tests/support/is_ok.hpp"
#include "tests/support/memory_files.hpp"
#include "tournaments/league/apply.hpp"

#include <gtest/gtest.h>

namespace mirocup::league {
namespace {

LeagueFile three_with_one_over_dds() {
  LeagueFile file;
  for (const char* name : {"a", "b", "c"}) {
    file.teams.push_back({.name = name, .source = "house:idle", .over_dds = *name == 'c'});
  }
  return file;
}

TEST(Shards, AreTheOpenFixturesWithoutTeamsOverDds) {
  LeagueState state = new_league(three_with_one_over_dds());
  apply(state, Started{.config_sha256 = "x", .version = ""});
  const auto ids = open_shards(state);
  ASSERT_EQ(ids.size(), 1u);
  const Fixture& fixture = state.fixtures[*state.find_fixture(ids[0])].fixture;
  EXPECT_NE(state.name(fixture.home), "c");
  EXPECT_NE(state.name(fixture.away), "c");
}

TEST(Shards, OfALeagueThatHasNotStartedAreRefused) {
  test_support::MemoryFiles files;
  const Folder folder{"l"};
  ASSERT_TRUE(files.write(folder.config(), print_league_file(three_with_one_over_dds())));
  const auto store = LeagueStore::open(files, folder);
  ASSERT_TRUE(test_support::is_ok(store));
  const auto played = play_shards(files, *store, {"r1-f1"});
  ASSERT_FALSE(played);
  EXPECT_EQ(played.error().code, Errc::input);
}

}  // namespace
}  // namespace mirocup::league
