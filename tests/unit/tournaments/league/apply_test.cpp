// SPDX-License-Identifier: MIT
//
// Catches an event that is accepted at a wrong time, and a change that an event should make and
// does not. play/league_play_test.cpp plays whole leagues.
#include "tournaments/league/apply.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace mirocup::league {
namespace {

LeagueState started_pair() {
  LeagueFile file;
  for (const char* name : {"a", "b"}) {
    file.teams.push_back({.name = name, .source = "house:idle", .over_dds = false});
  }
  LeagueState state = new_league(file);
  apply(state, Started{.config_sha256 = "x", .version = ""});
  return state;
}

LegPlayed win_of_home(const std::string& home, const std::string& away) {
  LegPlayed leg;
  leg.fixture = "r1-f1";
  leg.home = home;
  leg.away = away;
  leg.score = {.home = 2, .away = 1};
  leg.record = "records/r1-f1-1-1.json";
  return leg;
}

TEST(Apply, NothingBeforeTheStart) {
  const LeagueState state = new_league(started_pair().file);
  const auto valid = validate(state, Paused{.team = "a", .why = "w", .by = {}});
  ASSERT_FALSE(valid);
  EXPECT_EQ(valid.error().what, "the league has not started");
  EXPECT_TRUE(validate(state, Started{.config_sha256 = "x", .version = ""}));
}

TEST(Apply, OnlyOtherEntriesOfPresentTeams) {
  LeagueState state = started_pair();
  apply(state, EntryBooked{.team = "a", .entry = 2, .sha256 = "s"});
  EXPECT_EQ(state.teams[0].entry, 2);
  EXPECT_FALSE(validate(state, EntryBooked{.team = "a", .entry = 2, .sha256 = "t"}));
  EXPECT_FALSE(validate(state, EntryBooked{.team = "c", .entry = 1, .sha256 = "t"}));
  EXPECT_TRUE(validate(state, EntryBooked{.team = "a", .entry = 3, .sha256 = "t"}));
  EXPECT_TRUE(validate(state, EntryBooked{.team = "a", .entry = 1, .sha256 = "t"})) << "pinned";
}

// Catches a team that joins a round robin whose schedule it is not in, one that joins twice, and a
// state that is made again with two of it.
TEST(Apply, ATeamJoinsALeagueThatTakesEntries) {
  EXPECT_FALSE(validate(started_pair(), TeamJoined{.team = "c", .source = "submitted"}));
  LeagueFile file = started_pair().file;
  file.format.kind = FormatKind::nightly;
  LeagueState state = new_league(file);
  apply(state, Started{.config_sha256 = "x", .version = ""});
  const auto night = [&state](int number, const std::vector<EntryBooked>& entries) {
    const NightBegan began{.number = number, .entries = entries};
    ASSERT_TRUE(validate(state, began));
    apply(state, began);
  };
  night(1, {{.team = "a", .entry = 1, .sha256 = "s"}, {.team = "b", .entry = 1, .sha256 = "t"}});
  ASSERT_EQ(state.fixtures.size(), 1u);
  EXPECT_FALSE(validate(state, TeamJoined{.team = "../c", .source = "submitted"}));
  EXPECT_FALSE(validate(state, TeamJoined{.team = "a", .source = "submitted"}));
  state.shown_names = {"Team A", "Team B"};
  apply(state, TeamJoined{.team = "c", .source = "submitted"});
  EXPECT_EQ(state.find_team("c"), 2);
  EXPECT_EQ(state.shown_name(2), "c");
  EXPECT_EQ(state.fixtures.size(), 1u) << "the night that was played stays";
  night(2, {{.team = "c", .entry = 1, .sha256 = "u"}});
  EXPECT_EQ(state.fixtures.size(), 4u);
  EXPECT_EQ(new_league(state.file).teams.size(), 2u) << "those of league.json";
}

TEST(Apply, ARulingReplacesTheScoreAndKeepsTheRecord) {
  LeagueState state = started_pair();
  const Fixture& fixture = state.fixtures[0].fixture;
  apply(state, win_of_home(state.name(fixture.home), state.name(fixture.away)));
  const Ruled ruled{
      .fixture = "r1-f1", .leg = 1, .score = {.home = 0, .away = 10}, .why = "glue", .by = "H"};
  ASSERT_TRUE(validate(state, ruled));
  apply(state, ruled);
  const PlayedLeg& leg = *state.fixtures[0].legs[0].played;
  EXPECT_EQ(leg.result.away_goals, 10);
  EXPECT_EQ(leg.winner, fixture.away);
  EXPECT_EQ(leg.record, "records/r1-f1-1-1.json");
  EXPECT_EQ(leg.ruling, "glue (H)");
  EXPECT_EQ(leg.end, LegEnd::full_time);
}

TEST(Apply, NoNegativeScoreAndNoLegThatTheFixtureDoesNotNeed) {
  const LeagueState state = started_pair();
  Ruled ruled{.fixture = "r1-f1", .leg = 1, .score = {.home = -1, .away = 0}, .why = "w", .by = {}};
  EXPECT_FALSE(validate(state, ruled));
  ruled.score.home = 1;
  EXPECT_TRUE(validate(state, ruled));
  ruled.leg = 3;
  EXPECT_FALSE(validate(state, ruled));
}

TEST(Apply, ALineThatCannotBeDecodedIsDamage) {
  LeagueState state = started_pair();
  const auto applied = apply_line(state, {{"n", 4}, {"kind", "pause"}, {"team", "a"}}, "j.jsonl");
  ASSERT_FALSE(applied);
  EXPECT_EQ(applied.error().code, Errc::damaged);
  EXPECT_EQ(applied.error().what, "j.jsonl: line 4: /why: missing");
}

// Rounds used to be left out without a word.
TEST(Apply, ASwissRoundThatCannotBePairedIsSaid) {
  LeagueFile file;
  file.format.kind = FormatKind::swiss;
  for (const char* name : {"a", "b", "c", "d"})
    file.teams.push_back({.name = name, .source = "house:idle", .over_dds = false});
  LeagueState state = new_league(file);
  apply(state, Started{.config_sha256 = "x", .version = ""});
  const Fixture second = state.fixtures[1].fixture;
  for (const char* fixture : {"r1-f1", "r1-f2"}) {
    for (const int leg : {1, 2})
      apply(state, Ruled{.fixture = fixture, .leg = leg, .score = {1, 0}, .why = "w", .by = {}});
  }
  EXPECT_EQ(state.unpaired_round, 0);
  EXPECT_EQ(unpaired_in_words(state), "");
  for (const int team : {second.home, second.away})
    apply(state, Withdrawn{.team = state.name(team), .why = "left", .by = {}});
  EXPECT_EQ(state.unpaired_round, 2);
  EXPECT_NE(unpaired_in_words(state).find("round 2 of 2 is not played"), std::string::npos);
}

}  // namespace
}  // namespace mirocup::league
