// SPDX-License-Identifier: MIT
#include "tournaments/publish/grades.hpp"

#include "tests/support/is_ok.hpp"
#include "tournaments/league/apply.hpp"

#include <gtest/gtest.h>

namespace mirocup::league {
namespace {

// An overview points into its state, which a test therefore keeps.
LeagueState league_of_two() {
  LeagueFile file;
  file.title = "spring";
  for (const char* name : {"alpha", "be,ta"})
    file.teams.push_back({name, std::string(name) == "alpha" ? "house:idle" : "x.so", false});
  LeagueState state = new_league(file);
  league::apply(state, Started{.config_sha256 = "x", .version = ""});
  return state;
}

// Catches marks that are given to another team, and a name with a comma that is cut.
TEST(Grades, JoinTheTableWithTheMarksByName) {
  const LeagueState state = league_of_two();
  const auto file = grades(overview(state), {},
                           "team,drill,score,low,high,tries,failed_seeds\n"
                           "\"be,ta\",corner,12.5,1,2,60,\n\"be,ta\",all,20.0,,,60,\n"
                           "alpha,all,70.0,,,60,1 2\n",
                           "d.csv");
  ASSERT_TRUE(test_support::is_ok(file));
  EXPECT_EQ(file->name, "grades.csv");
  EXPECT_EQ(
      file->bytes.rfind("rank,team,points,played,strength,strength_low,strength_high,house_beaten,"
                        "display,members,corner,all\r\n",
                        0),
      0u)
      << file->bytes;
  EXPECT_NE(file->bytes.find(",12.5,20.0\r\n"), std::string::npos) << file->bytes;
  EXPECT_NE(file->bytes.find("\"be,ta\","), std::string::npos);
  EXPECT_NE(file->bytes.find(",,70.0\r\n"), std::string::npos) << "no mark, no number";
}

// Catches a list that names the beaten for the winner, or a team that is no house team; and members
// that are lost.
TEST(Grades, NameTheHouseTeamsThatWereBeaten) {
  LeagueState state = league_of_two();
  for (const int leg : {1, 2}) {
    league::apply(state, Ruled{.fixture = "r1-f1",
                               .leg = leg,
                               .score = state.name(state.fixtures[0].fixture.home) == "alpha"
                                            ? HomeAway{0, leg}
                                            : HomeAway{leg, 0},
                               .why = "w",
                               .by = {}});
  }
  const auto file =
      grades(overview(state), {{"be,ta", {.display = "Löwen", .members = {"Ada", "Bo"}}}}, "", "");
  ASSERT_TRUE(test_support::is_ok(file));
  EXPECT_NE(file->bytes.find(",alpha,Löwen,Ada; Bo\r\n"), std::string::npos) << file->bytes;
  EXPECT_NE(file->bytes.find("2,alpha,0,2,"), std::string::npos) << file->bytes;
  EXPECT_NE(file->bytes.find(",,,\r\n"), std::string::npos) << "alpha has beaten nobody";
}

TEST(Grades, RefuseAFileOfAnotherKind) {
  const LeagueState state = league_of_two();
  EXPECT_FALSE(grades(overview(state), {}, "name;mark\nalpha;1\n", "d.csv"));
  EXPECT_FALSE(grades(overview(state), {}, "team,drill,score,low\nalpha\n", "d.csv"));
  const auto strangers =
      grades(overview(state), {}, "team,drill,score,low\ngamma,all,50.0,1\n", "d.csv");
  ASSERT_FALSE(strangers);
  EXPECT_NE(strangers.error().what.find("d.csv: it has no team of this league"), std::string::npos);
}

}  // namespace
}  // namespace mirocup::league
