// SPDX-License-Identifier: MIT
//
// Catches an event that is accepted at a wrong time, and a change that an event should make and
// does not. play/league_play_test.cpp plays whole leagues.
#include "tests/unit/tournaments/small_league.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <array>

namespace mirocup::league {
namespace {

LeagueState started_pair() {
  return started_league(league_file_of({"a", "b"}));
}

// A person decides both legs of a fixture.
void rule(LeagueState& state, const std::string& fixture, HomeAway score) {
  for (const int leg : {1, 2})
    apply(state, Ruled{.fixture = fixture, .leg = leg, .score = score, .signature = {"w"}});
}

void withdraw(LeagueState& state, const std::string& team,
              WithdrawnResults results = WithdrawnResults::keep) {
  apply(state, Withdrawn{.team = team, .results = results, .signature = {"left"}});
}

TEST(Apply, NothingBeforeTheStart) {
  const LeagueState state = new_league(started_pair().file);
  const auto valid = validate(state, Paused{.team = "a", .signature = {"w"}});
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
  LeagueState state = started_league(league_file_of({"a", "b"}, {.kind = FormatKind::nightly}));
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
  apply(state, played_leg(state, fixture, 1, {.home = 2, .away = 1}));
  const Ruled ruled{
      .fixture = "r1-f1", .leg = 1, .score = {.home = 0, .away = 10}, .signature = {"glue", "H"}};
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
  Ruled ruled{.fixture = "r1-f1", .leg = 1, .score = {.home = -1, .away = 0}, .signature = {"w"}};
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
  LeagueState state =
      started_league(league_file_of({"a", "b", "c", "d"}, {.kind = FormatKind::swiss}));
  const Fixture second = state.fixtures[1].fixture;
  for (const char* fixture : {"r1-f1", "r1-f2"}) rule(state, fixture, {1, 0});
  EXPECT_EQ(state.unpaired_round, 0);
  EXPECT_EQ(unpaired_in_words(state), "");
  for (const int team : {second.home, second.away}) withdraw(state, state.name(team));
  EXPECT_EQ(state.unpaired_round, 2);
  EXPECT_NE(unpaired_in_words(state).find("round 2 of 2 is not played"), std::string::npos);
}

// Decides each leg that is open, for the team that comes first in the list.
void decide_all(LeagueState& state) {
  for (bool more = true; more;) {
    more = false;
    for (std::size_t i = 0; i < state.fixtures.size(); ++i) {
      const FixtureState& f = state.fixtures[i];
      for (int leg = 1; f.fixture.has_both() && leg <= f.needed(); ++leg) {
        if (f.legs[leg - 1].played) continue;
        const bool is_home = f.fixture.home < f.fixture.away;
        apply(state, Ruled{.fixture = f.fixture.id(),
                           .leg = leg,
                           .score = {is_home ? 1 : 0, is_home ? 0 : 1},
                           .signature = {"w"}});
        more = true;
      }
    }
  }
}

// Returns what each tie was and how it ended.
std::vector<std::array<int, 5>> ties_of(const LeagueState& state) {
  std::vector<std::array<int, 5>> ties;
  for (const FixtureState& f : state.fixtures) {
    const TieOutcome o = outcome(state, f);
    ties.push_back({f.fixture.home, f.fixture.away, o.winner, o.loser, f.decided()});
  }
  return ties;
}

// A tie that teams did not play because they had left used to be decided anew when others left:
// ties and places of a knockout that was over changed.
TEST(Apply, AWalkoverIsDecidedOnce) {
  for (const std::string first : {"ab", "ac", "bd", "cd", "a", "d"}) {
    LeagueState state =
        started_league(league_file_of({"a", "b", "c", "d", "e"}, {.kind = FormatKind::knockout}));
    rule(state, state.fixtures[0].fixture.id(), {1, 0});
    for (const char team : first) withdraw(state, {team});
    decide_all(state);
    const auto before = ties_of(state);
    const int legs = state.legs();
    for (const char team : std::string("abcde")) {
      if (first.find(team) != std::string::npos) continue;
      withdraw(state, {team});
      EXPECT_EQ(ties_of(state), before) << first << ", then " << team;
      EXPECT_EQ(state.legs(), legs) << first << ", then " << team;
    }
  }
}

// The table of a group that is over used to send other teams on when one was annulled.
TEST(Apply, WhoCameOutOfAGroupStays) {
  LeagueState state = started_league(
      league_file_of({"a", "b", "c", "d", "e", "f", "g", "h"}, {.kind = FormatKind::groups}));
  for (const FixtureState& f : state.fixtures) {
    if (f.fixture.part != Part::group) continue;
    rule(state, f.fixture.id(), f.fixture.home < f.fixture.away ? HomeAway{1, 0} : HomeAway{0, 1});
  }
  const auto before = ties_of(state);
  const int second = state.fixtures.back().fixture.home;
  EXPECT_EQ(second, unknown_team);
  for (const char* team : {"h", "a"}) withdraw(state, team, WithdrawnResults::annul);
  const auto after = ties_of(state);
  for (std::size_t i = 0; i < before.size(); ++i) {
    if (state.fixtures[i].fixture.part != Part::knockout || before[i][0] < 0) continue;
    EXPECT_EQ(after[i][0], before[i][0]);
    EXPECT_EQ(after[i][1], before[i][1]);
  }
  // A ruling does change who goes on.
  LeagueState other =
      started_league(league_file_of({"a", "b", "c", "d"}, {.kind = FormatKind::knockout}));
  rule(other, "k1-f1", {1, 0});
  withdraw(other, "c");
  const int finalist = other.fixtures[2].fixture.home;
  rule(other, "k1-f1", {0, 1});
  EXPECT_NE(other.fixtures[2].fixture.home, finalist);
}

}  // namespace
}  // namespace mirocup::league
