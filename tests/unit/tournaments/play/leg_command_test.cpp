// SPDX-License-Identifier: MIT
//
// Catches a leg that is played by the wrong teams or with the wrong seed, and one that is started
// although a team may not play.
#include "tournaments/play/leg_command.hpp"

#include "tests/unit/tournaments/small_league.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace mirocup::league {
namespace {

LeagueState league_of_two(FormatKind kind) {
  return league_with_entries(league_file_of({"a", "b"}, {.kind = kind}));
}

// The argument after an option; "" if the option is missing.
std::string value_of(const std::vector<std::string>& command, const std::string& option) {
  const auto found = std::find(command.begin(), command.end(), option);
  return found == command.end() ? "" : *(found + 1);
}

TEST(LegCommand, SwapsColoursFromLegToLegAndKeepsTheSeed) {
  const LeagueState state = league_of_two(FormatKind::double_round_robin);
  const Folder folder{"l"};
  const Fixture& fixture = state.fixtures[0].fixture;
  const auto first = leg_command(folder, state, {.fixture = fixture, .leg = 1}, "m");
  const auto second = leg_command(folder, state, {.fixture = fixture, .leg = 2}, "m");
  EXPECT_EQ(value_of(first, "--blue-name"), state.name(fixture.home));
  EXPECT_EQ(value_of(second, "--blue-name"), state.name(fixture.away));
  EXPECT_EQ(value_of(first, "--blue"), value_of(second, "--yellow"));
  EXPECT_EQ(value_of(first, "--seed"), value_of(second, "--seed"));
  EXPECT_EQ(value_of(first, "--record"), "l/records/r1-f1-1-1.json");
  EXPECT_EQ(value_of(first, "--stage"), "");
}

// Catches thoughts that are kept where the host did not ask for them, and not where it did.
TEST(LegCommand, KeepsThoughtsWhereTheLeagueSaysSo) {
  LeagueState state = league_of_two(FormatKind::double_round_robin);
  const auto keeps = [&] {
    const LegId id{.fixture = state.fixtures[0].fixture, .leg = 1};
    const auto leg = leg_command(Folder{"l"}, state, id, "m");
    const auto friendly = friendly_command(
        state, {.blue = {"a.so", "a"}, .yellow = {"b.so", "b"}, .seed = 1, .record = "f.json"});
    const bool in_leg = std::find(leg.begin(), leg.end(), "--thoughts") != leg.end();
    EXPECT_EQ(std::find(friendly.begin(), friendly.end(), "--thoughts") != friendly.end(), in_leg);
    return in_leg;
  };
  EXPECT_FALSE(keeps());
  state.file.keeps_thoughts = true;
  EXPECT_TRUE(keeps());
}

// Catches parameters that stay with a colour when the teams swap theirs, and those of a team on the
// network, which `mirocup match` would refuse.
TEST(LegCommand, GivesATeamItsParametersInBothColours) {
  LeagueState state = league_of_two(FormatKind::double_round_robin);
  const Fixture& fixture = state.fixtures[0].fixture;
  state.file.teams[fixture.home].parameters = {{"wait", 0.1}};
  const auto first = leg_command(Folder{"l"}, state, {.fixture = fixture, .leg = 1}, "m");
  const auto second = leg_command(Folder{"l"}, state, {.fixture = fixture, .leg = 2}, "m");
  EXPECT_EQ(value_of(first, "--blue-param"), "wait=0.1");
  EXPECT_EQ(value_of(first, "--yellow-param"), "");
  EXPECT_EQ(value_of(second, "--blue-param"), "");
  EXPECT_EQ(value_of(second, "--yellow-param"), "wait=0.1");
  state.file.teams[fixture.home].over_dds = true;
  const auto remote = leg_command(Folder{"l"}, state, {.fixture = fixture, .leg = 1}, "m");
  EXPECT_EQ(value_of(remote, "--blue-param"), "");
}

// Catches two legs of started programs at one address, one of people's programs at an address that
// they do not know, and lock-step for a program that lives by the clock.
TEST(LegCommand, TellsProgramsForFirasimWhereTheyMeet) {
  LeagueState state = league_of_two(FormatKind::double_round_robin);
  const LegId leg{.fixture = state.fixtures[0].fixture};
  TeamConfig& blue = state.file.teams[leg.fixture.home];
  blue.source = "firasim:it";
  blue.program = {.run = "./it's", .folder = "/its place", .lockstep = true};
  auto command = leg_command(Folder{"l"}, state, leg, "m");
  EXPECT_EQ(value_of(command, "--blue"), "firasim:it");
  EXPECT_EQ(value_of(command, "--blue-program"), "cd '/its place' && ./it's");
  EXPECT_EQ(value_of(command, "--firasim-instance"), "auto");
  EXPECT_NE(std::find(command.begin(), command.end(), "--lockstep"), command.end());
  state.file.firasim.instance = 7;
  state.file.firasim.vision = "127.0.0.1:1";
  state.file.teams[leg.fixture.away].source = "firasim:other";
  command = leg_command(Folder{"l"}, state, leg, "m");
  EXPECT_EQ(value_of(command, "--firasim-instance"), "7");
  EXPECT_EQ(value_of(command, "--firasim-vision"), "127.0.0.1:1");
  EXPECT_EQ(std::find(command.begin(), command.end(), "--lockstep"), command.end());
}

TEST(LegCommand, NamesTheConditionsOfTheLeague) {
  LeagueState state = league_of_two(FormatKind::double_round_robin);
  const LegId leg{.fixture = state.fixtures[0].fixture, .leg = 1};
  EXPECT_EQ(value_of(leg_command(Folder{"l"}, state, leg, "m"), "--conditions"), "exact")
      << "started without any";
  state.conditions = match::conditions_of(match::ConditionsPreset::camera);
  state.conditions.delay_ticks = 2;
  const auto command = leg_command(Folder{"l"}, state, leg, "m");
  EXPECT_EQ(value_of(command, "--conditions"), "camera");
  EXPECT_EQ(value_of(command, "--condition"), "delay_ticks=2");
}

TEST(LegCommand, PlaysTheLegThatDecidesATieAsAKnockoutWithASeedOfItsOwn) {
  const LeagueState state = league_of_two(FormatKind::knockout);
  const Fixture& tie = state.fixtures[0].fixture;
  const auto command = leg_command(Folder{"l"}, state, {.fixture = tie, .leg = 3}, "m");
  EXPECT_EQ(value_of(command, "--stage"), "knockout");
  EXPECT_NE(leg_seed(state, {.fixture = tie, .leg = 3}), leg_seed(state, {.fixture = tie}));
}

TEST(OpenLegs, AreThoseOfPresentTeamsThatAreNotDecided) {
  LeagueState state = league_of_two(FormatKind::double_round_robin);
  EXPECT_EQ(open_legs(state, state.fixtures[0]), (std::vector<int>{1, 2}));
  apply(state, Ruled{.fixture = "r1-f1", .leg = 1, .score = {}, .signature = {"w"}});
  EXPECT_EQ(open_legs(state, state.fixtures[0]), (std::vector<int>{2}));
  apply(state, Paused{.team = "a", .signature = {"w"}});
  EXPECT_TRUE(open_legs(state, state.fixtures[0]).empty());
}

}  // namespace
}  // namespace mirocup::league
