// SPDX-License-Identifier: MIT
//
// Catches shards of fixtures that only one host can play.
#include "tournaments/play/shard.hpp"

#include "tests/unit/tournaments/small_league.hpp"

#include <gtest/gtest.h>

namespace mirocup::league {
namespace {

TEST(Shards, AreTheOpenFixturesWithoutTeamsOverDds) {
  LeagueFile file = league_file_of({"a", "b", "c"});
  file.teams[2].over_dds = true;
  const LeagueState state = started_league(file);
  const auto ids = open_shards(state);
  ASSERT_EQ(ids.size(), 1u);
  const Fixture& fixture = state.fixtures[*state.find_fixture(ids[0])].fixture;
  EXPECT_NE(state.name(fixture.home), "c");
  EXPECT_NE(state.name(fixture.away), "c");
}

}  // namespace
}  // namespace mirocup::league
