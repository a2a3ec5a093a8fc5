// SPDX-License-Identifier: MIT
//
// Whole leagues of every format and size, with made-up results in any order. Catches a schedule
// that depends on the order of results, a league that never ends, a tie without a winner, a ruling
// that changes who has played already, a team that has left and still plays.
#include "tests/unit/tournaments/sizes.hpp"
#include "tests/unit/tournaments/small_league.hpp"
#include "tests/unit/tournaments/whole_site.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <set>

namespace mirocup::league {
namespace {

void take(LeagueState& state, const Event& event) {
  const auto valid = validate(state, event);
  ASSERT_TRUE(valid) << fields_of(event).dump() << ": " << valid.error().what;
  league::apply(state, event);
}

LeagueState started(FormatKind kind, int teams) {
  return league_with_entries(numbered_teams(kind, teams));
}

struct OpenLeg {
  int fixture;
  int leg;
};

std::vector<OpenLeg> open_legs(const LeagueState& state) {
  std::vector<OpenLeg> open;
  for (int i = 0; i < static_cast<int>(state.fixtures.size()); ++i) {
    const FixtureState& f = state.fixtures[i];
    if (!f.fixture.has_both()) continue;
    for (int leg = 1; leg <= f.needed(); ++leg) {
      if (!f.legs[leg - 1].played) open.push_back({i, leg});
    }
  }
  return open;
}

LegPlayed leg_result(const LeagueState& state, const OpenLeg& open,
                     LegEnd end = LegEnd::full_time) {
  LegPlayed leg = made_up_leg(state, state.fixtures[open.fixture].fixture, open.leg);
  leg.end = end;
  return leg;
}

void play_out(LeagueState& state, std::uint64_t seed) {
  Random random(seed);
  for (int guard = 0; guard < 10'000; ++guard) {
    std::vector<OpenLeg> open = open_legs(state);
    if (open.empty()) return;
    // Only half of the open legs are played before the next search, so that newly opened legs mix
    // with the others.
    for (std::size_t left = (open.size() + 1) / 2; left > 0; --left) {
      const auto drawn = open.begin() + static_cast<std::ptrdiff_t>(random.below(open.size()));
      take(state, leg_result(state, *drawn));
      open.erase(drawn);
    }
  }
  FAIL() << "it does not end";
}

// Maximum number of teams for which pages are made: fitting strengths for more takes long and tests
// nothing new.
constexpr int max_teams_with_pages = 17;

void expect_the_same_end_in_any_order(FormatKind kind, int teams) {
  LeagueState one = started(kind, teams);
  LeagueState other = started(kind, teams);
  play_out(one, 1);
  play_out(other, 2);
  EXPECT_TRUE(one.is_over()) << to_string(kind);
  EXPECT_EQ(one.played(), one.legs()) << to_string(kind);
  ASSERT_EQ(one.fixtures.size(), other.fixtures.size()) << to_string(kind);
  for (std::size_t i = 0; i < one.fixtures.size(); ++i) {
    EXPECT_EQ(one.fixtures[i].fixture.id(), other.fixtures[i].fixture.id());
    EXPECT_EQ(one.fixtures[i].fixture.home, other.fixtures[i].fixture.home);
    EXPECT_EQ(one.fixtures[i].fixture.away, other.fixtures[i].fixture.away);
  }
  EXPECT_EQ(table_text(one), table_text(other)) << to_string(kind);
  if (teams > max_teams_with_pages) return;
  const auto site = make_site({one});
  const auto again = make_site({other});
  ASSERT_EQ(site.size(), again.size());
  for (std::size_t i = 0; i < site.size(); ++i)
    EXPECT_EQ(site[i].bytes, again[i].bytes) << to_string(kind) << " " << site[i].name;
}

class EveryRoundRobin : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Sizes, EveryRoundRobin, testing::Values(2, 3, 4, 5, 6, 7, 8, 9, 12, 17));

TEST_P(EveryRoundRobin, ComesToTheSameEndInWhateverOrderItIsPlayed) {
  for (const auto kind : {FormatKind::double_round_robin, FormatKind::round_robin})
    expect_the_same_end_in_any_order(kind, GetParam());
}

// Formats that grow while they are played.
class EveryFormat : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Sizes, EveryFormat, all_sizes());

TEST_P(EveryFormat, ComesToTheSameEndInWhateverOrderItIsPlayed) {
  for (const auto kind :
       {FormatKind::groups, FormatKind::knockout, FormatKind::swiss, FormatKind::ladder}) {
    if (kind != FormatKind::groups || GetParam() >= 4)
      expect_the_same_end_in_any_order(kind, GetParam());
  }
}

TEST_P(EveryFormat, OfAKnockoutDecidesEveryTieAndPutsTheChampionFirst) {
  const int n = GetParam();
  LeagueState state = started(FormatKind::knockout, n);
  play_out(state, static_cast<std::uint64_t>(n));
  TieOutcome final;
  for (const FixtureState& f : state.fixtures) {
    const TieOutcome o = outcome(state, f);
    EXPECT_GE(o.winner, 0) << f.fixture.id();
    EXPECT_GE(o.loser, 0) << f.fixture.id();
    if (f.fixture.home_source.kind != TeamSource::Kind::loser) final = o;
  }
  const auto table = state.table();
  EXPECT_EQ(table[0].team, final.winner);
  EXPECT_EQ(table[1].team, final.loser);
}

// Plays a league in which teams leave, at most all but one.
void play_while_teams_leave(LeagueState& state, std::uint64_t seed) {
  const std::size_t n = state.teams.size();
  Random random(seed);
  std::size_t left = 0;
  for (std::size_t i = 0; i < 4 * n && !open_legs(state).empty(); ++i) {
    const auto open = open_legs(state);
    take(state, leg_result(state, open[random.below(open.size())]));
    const int team = static_cast<int>(random.below(n));
    const bool leaves = random.below(3) == 0 && left + 1 < n;
    if (!leaves || state.teams[team].status == TeamStatus::withdrawn) continue;
    take(state,
         Withdrawn{
             .team = state.name(team), .results = WithdrawnResults::keep, .signature = {"test"}});
    ++left;
  }
}

TEST_P(EveryFormat, EndsWhoeverLeaves) {
  const int n = GetParam();
  for (const auto kind : {FormatKind::groups, FormatKind::knockout, FormatKind::swiss}) {
    if (kind == FormatKind::groups && n < 4) continue;
    LeagueState state = started(kind, n);
    play_while_teams_leave(state, static_cast<std::uint64_t>(n));
    for (const OpenLeg& open : open_legs(state)) {
      const Fixture& f = state.fixtures[open.fixture].fixture;
      EXPECT_EQ(state.teams[f.home].status, TeamStatus::playing) << f.id();
      EXPECT_EQ(state.teams[f.away].status, TeamStatus::playing) << f.id();
    }
    play_out(state, 3);
    EXPECT_TRUE(state.is_over()) << to_string(kind);
    EXPECT_EQ(state.played(), state.legs()) << to_string(kind);
    EXPECT_TRUE(state.fixtures.back().is_decided()) << to_string(kind);
  }
}

TEST(LeagueState, PlaysOneMoreLegOfALevelTieAndNoFourth) {
  LeagueState state = started(FormatKind::knockout, 2);
  const auto draw = [&state](int leg) {
    LegPlayed line = leg_result(state, {0, leg});
    line.score = {.home = 1, .away = 1};
    return line;
  };
  EXPECT_EQ(state.legs(), 2);
  take(state, draw(1));
  EXPECT_FALSE(validate(state, draw(3))) << "not before the second";
  take(state, draw(2));
  EXPECT_EQ(state.legs(), 3);
  EXPECT_FALSE(state.is_over());
  take(state, draw(3));  // a double forfeit, say: a lot decides
  EXPECT_TRUE(state.is_over());
  EXPECT_GE(outcome(state, state.fixtures[0]).winner, 0);
  EXPECT_FALSE(validate(state, draw(4)));
}

TEST(LeagueState, GivesATieToWhoWonItsShootOut) {
  for (const char* winner : {"t0", "t1"}) {
    LeagueState state = started(FormatKind::knockout, 2);
    for (const int leg : {1, 2, 3}) {
      LegPlayed line =
          leg_result(state, {0, leg}, leg == 3 ? LegEnd::shoot_out : LegEnd::full_time);
      line.score = {.home = 0, .away = 0};
      if (leg == 3) line.winner = winner;
      take(state, line);
    }
    EXPECT_EQ(state.name(outcome(state, state.fixtures[0]).winner), winner);
  }
}

TEST(LeagueState, LetsARulingChangeATieOnlyUntilItsWinnerPlays) {
  LeagueState state = started(FormatKind::knockout, 4);
  for (const int tie : {0, 1}) {
    for (const int leg : {1, 2}) {
      LegPlayed line = leg_result(state, {tie, leg});
      line.score = {.home = 1, .away = 0};
      take(state, line);
    }
  }
  const int final = 2;
  ASSERT_TRUE(state.fixtures[final].fixture.has_both());
  const int loser = state.fixtures[0].fixture.away;
  const Ruled ruling{
      .fixture = "k1-f1", .leg = 1, .score = {.home = 0, .away = 10}, .signature = {"pushed"}};
  take(state, ruling);
  EXPECT_EQ(state.fixtures[final].fixture.home, loser) << "the final has not begun";
  take(state, leg_result(state, {final, 1}));
  const auto late = validate(state, ruling);
  ASSERT_FALSE(late);
  EXPECT_NE(late.error().what.find("k2-f1 depends on"), std::string::npos) << late.error().what;
}

TEST(LeagueState, LetsWhoStaysWinAgainstWhoHasLeftOrCountsNothing) {
  for (const bool annul : {false, true}) {
    LeagueState state = started(FormatKind::double_round_robin, 3);
    const auto open = open_legs(state);
    take(state, leg_result(state, open[0]));
    const Fixture& f = state.fixtures[0].fixture;
    const std::string leaver = state.name(f.home);
    const int other = f.away;
    take(state, Withdrawn{.team = leaver,
                          .results = annul ? WithdrawnResults::annul : WithdrawnResults::keep,
                          .signature = {"test"}});
    EXPECT_EQ(state.legs(), annul ? 2 : 6);
    EXPECT_EQ(state.played(), annul ? 0 : 4);
    EXPECT_EQ(open_legs(state).size(), 2u) << "between those who stay";
    const auto table = state.table();
    const TableRow row = *std::find_if(table.begin(), table.end(),
                                       [other](const TableRow& r) { return r.team == other; });
    EXPECT_EQ(row.played, annul ? 0 : 2);
    EXPECT_FALSE(validate(state, EntryBooked{.team = leaver, .entry = 2, .sha256 = "s"}));
  }
}

TEST(LeagueState, PlaysAVoidedLegAgainUnderANewRecord) {
  LeagueState state = started(FormatKind::double_round_robin, 2);
  const LegPlayed leg = leg_result(state, {0, 1});
  const LegVoided by_host{
      .fixture = "r1-f1", .leg = 1, .attempt = 1, .cause = VoidCause::host, .signature = {"host"}};
  LegVoided by_person = by_host;
  by_person.cause = VoidCause::ruling;
  EXPECT_FALSE(validate(state, by_person)) << "nothing is decided";
  take(state, by_host);
  EXPECT_EQ(state.fixtures[0].legs[0].version, 1);
  EXPECT_EQ(state.fixtures[0].legs[0].host_faults, 1);
  take(state, leg);
  EXPECT_FALSE(validate(state, by_host)) << "it is decided";
  take(state, by_person);
  EXPECT_EQ(state.played(), 0);
  EXPECT_EQ(state.fixtures[0].legs[0].version, 2) << "the first record is evidence";
  take(state, leg);
  EXPECT_EQ(state.played(), 1);
}

// Catches an attempt that overwrites the record of a void one, and words of a ruling without one.
TEST(LeagueState, PlaysALegAgainWhoseRecordWasRefused) {
  LeagueState state = started(FormatKind::double_round_robin, 2);
  LegVoided refused{.fixture = "r1-f1", .leg = 1, .attempt = 1, .signature = {"differs"}};
  refused.has_new_seed = true;
  take(state, refused);
  const LegState& leg = state.fixtures[0].legs[0];
  EXPECT_EQ(leg.version, 2) << "the record is evidence";
  EXPECT_EQ(leg.host_faults, 1);
  EXPECT_EQ(leg.new_seeds, 1);
  take(state, leg_result(state, {0, 1}));
  EXPECT_EQ(leg.played->ruling, "");
}

TEST(LeagueState, CountsOwnFaultsInARow) {
  LeagueState state = started(FormatKind::round_robin, 4);
  const auto play = [&state](const std::string& culprit) {
    for (const OpenLeg& open : open_legs(state)) {
      const Fixture& f = state.fixtures[open.fixture].fixture;
      if (f.home != 0 && f.away != 0) continue;
      LegPlayed line = leg_result(state, open, LegEnd::forfeit);
      if (!culprit.empty()) line.fault = {.team = culprit, .code = "crash", .text = "signal 11"};
      take(state, line);
      return;
    }
  };
  play("t0");
  play("t0");
  EXPECT_EQ(state.teams[0].strikes, 2);
  play("");
  EXPECT_EQ(state.teams[0].strikes, 0);
  const Paused paused{.team = "t0", .signature = {"test"}};
  take(state, paused);
  EXPECT_FALSE(validate(state, paused));
  take(state, Resumed{.team = "t0", .signature = {""}});
}

TEST(Ladder, ForgetsWhatTheEntryBeforeDid) {
  LeagueState state = started(FormatKind::ladder, 3);
  play_out(state, 1);
  const auto played_by = [&state](int team) {
    const auto table = state.table();
    return std::find_if(table.begin(), table.end(),
                        [team](const TableRow& r) { return r.team == team; })
        ->played;
  };
  EXPECT_GT(played_by(0), 0);
  const int others = played_by(1);
  take(state, EntryBooked{.team = "t0", .entry = 2, .sha256 = "s"});
  EXPECT_EQ(played_by(0), 0);
  EXPECT_EQ(played_by(1), others) << "the others keep what they won";
  EXPECT_EQ(open_legs(state).size(), 4u) << "against both others";
  play_out(state, 2);
  EXPECT_EQ(played_by(0), 4);
  EXPECT_TRUE(state.is_over());
}

TEST(LeagueState, RefusesALegThatIsDecidedOrOfOtherTeamsAndASecondStart) {
  LeagueState state = started(FormatKind::double_round_robin, 3);
  const LegPlayed good = leg_result(state, {0, 1});
  LegPlayed elsewhere = good;
  elsewhere.home = good.away;
  EXPECT_FALSE(validate(state, elsewhere));
  EXPECT_FALSE(validate(state, Started{.config_sha256 = "x", .version = ""}));
  take(state, good);
  EXPECT_FALSE(validate(state, good)) << "decided already";
}

}  // namespace
}  // namespace mirocup::league
