// SPDX-License-Identifier: MIT
#include "tournaments/publish/grades.hpp"

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
  ASSERT_TRUE(file) << file.error().what;
  EXPECT_EQ(file->name, "grades.csv");
  EXPECT_EQ(
      file->bytes.rfind("rank,team,points,played,strength,strength_low,strength_high,house_beaten,"
                        "display,members,points_per_leg,state,entry,corner,all\r\n",
                        0),
      0u)
      << file->bytes;
  EXPECT_NE(file->bytes.find(",12.5,20.0\r\n"), std::string::npos) << file->bytes;
  EXPECT_NE(file->bytes.find("\"be,ta\","), std::string::npos);
  EXPECT_NE(file->bytes.find(",,70.0\r\n"), std::string::npos) << "no mark, no number";
}

// Outputs of several drills in one file have several lines of titles, and an "all" each.
TEST(Grades, JoinTheOutputsOfSeveralDrills) {
  const LeagueState state = league_of_two();
  const std::string first =
      "team,drill,score\nalpha,x,10.0\nalpha,all,10.0\n\"be,ta\",x,1.0\n\"be,ta\",all,1.0\n";
  const std::string both = first + "team,drill,score\nalpha,y,21.0\nalpha,all,21.0\n";
  const auto file = grades(overview(state), {}, both, "d.csv");
  ASSERT_TRUE(file) << file.error().what;
  EXPECT_NE(file->bytes.find(",entry,x,y,all\r\n"), std::string::npos) << file->bytes;
  EXPECT_NE(file->bytes.find(",10.0,21.0,15.5\r\n"), std::string::npos) << file->bytes;
  EXPECT_NE(file->bytes.find(",1.0,,\r\n"), std::string::npos) << "a drill is missing";
  const auto again = grades(overview(state), {}, first + first, "d.csv");
  ASSERT_FALSE(again);
  EXPECT_EQ(again.error().what, "d.csv: line 7: alpha has a score in x already");
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
  ASSERT_TRUE(file) << file.error().what;
  EXPECT_NE(file->bytes.find(",alpha,Löwen,Ada; Bo,"), std::string::npos) << file->bytes;
  EXPECT_NE(file->bytes.find("2,alpha,0,2,"), std::string::npos) << file->bytes;
  EXPECT_NE(file->bytes.find(",,,,0.000,no entry,\r\n"), std::string::npos)
      << "alpha has beaten nobody";
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

// The exam office wants a row for each team of the class list, whatever became of it.
TEST(Grades, HaveARowForEachTeam) {
  LeagueState state = league_of_two();
  const auto& f = state.fixtures[0].fixture;
  const bool is_home = state.name(f.home) == "alpha";
  for (const int leg : {1, 2}) {
    league::apply(state, Ruled{.fixture = "r1-f1",
                               .leg = leg,
                               .score = is_home ? HomeAway{2, 0} : HomeAway{0, 2},
                               .why = "w",
                               .by = {}});
  }
  league::apply(state, Withdrawn{.team = "alpha", .why = "left", .by = {}});
  const auto file = grades(overview(state), {{"late", {.display = "=1+2", .members = {}}}}, "", "");
  ASSERT_TRUE(file) << file.error().what;
  EXPECT_NE(file->bytes.find("\r\n1,\"be,ta\",0,2,"), std::string::npos) << file->bytes;
  EXPECT_NE(file->bytes.find("\r\n2,alpha,6,2,"), std::string::npos) << "the withdrawn come last";
  EXPECT_NE(file->bytes.find(",3.000,withdrawn,"), std::string::npos) << file->bytes;
  EXPECT_NE(file->bytes.find("\r\n,late,0,0,,,,,'=1+2,,0.000,not in the league,\r\n"),
            std::string::npos)
      << file->bytes;
}

// Catches a mark in the row of another team, and per cent of points where the staff has a scale.
TEST(Grades, HaveAMarkIfThereIsAScale) {
  const LeagueState state = league_of_two();
  PeopleOfTeams people;
  people["alpha"] = {.display = "A", .members = {"Ada"}, .more = {{"mail", "ada@x"}}};
  people["be,ta"] = {.display = "B", .members = {"Bo"}, .more = {{"mail", "bo@x"}}};
  const MarksOfTeams marks{ScaleMark{1.7, 2.1, 1.3, true}, std::nullopt};
  const auto file = grades(overview(state), people, "", "", GradesLayout::teams, marks);
  ASSERT_TRUE(file) << file.error().what;
  EXPECT_NE(file->bytes.find(",mark,mark_low,mark_high,mark_decided\r\n"), std::string::npos);
  EXPECT_NE(file->bytes.find(",ada@x,1.70,2.10,1.30,yes\r\n"), std::string::npos) << file->bytes;
  EXPECT_NE(file->bytes.find(",bo@x,,,,\r\n"), std::string::npos) << file->bytes;
  const auto moodle = grades(overview(state), people, "", "", GradesLayout::moodle, marks);
  ASSERT_TRUE(moodle);
  EXPECT_NE(moodle->bytes.find("ada@x,,1.70\r\n"), std::string::npos) << moodle->bytes;
}

TEST(Scale, NamesAtLeastTwoHouseTeams) {
  const auto scale = read_scale(R"([{"mark": 5}, {"mark": 4, "beats": "chaser"},
                                    {"mark": 1, "beats": "tactician"}])",
                                "s.json");
  ASSERT_TRUE(scale) << scale.error().what;
  EXPECT_EQ(scale->below, 5.0);
  ASSERT_EQ(scale->steps.size(), 2u);
  EXPECT_EQ(scale->steps[1].beats, "tactician");
  EXPECT_EQ(read_scale(R"([{"mark": 4, "beats": "a"}, {"mark": 1, "beats": "b"}])", "s")->below, 4);
  for (const char* wrong :
       {R"([{"mark": 4, "beats": "a"}])", R"([{"mark": 4, "beats": "a"}, {"mark": 1}])",
        R"([{"mark": 5}, {"mark": 4, "beats": "a"}])", R"([{"mark": "x"}, {"mark": 1}])", "{}"}) {
    EXPECT_FALSE(read_scale(wrong, "s.json")) << wrong;
  }
}

TEST(Grades, HaveARowForEachStudent) {
  const LeagueState state = league_of_two();
  PeopleOfTeams people;
  people["alpha"] = {
      .display = "A", .members = {"Ada", "Bo"}, .more = {{"E-Mail", "ada@x; bo@x"}, {"room", "7"}}};
  people["be,ta"] = {.display = "B", .members = {"Cy"}, .more = {{"E-Mail", "cy@x"}}};
  const auto each = grades(overview(state), people, "", "", GradesLayout::members);
  ASSERT_TRUE(each) << each.error().what;
  EXPECT_NE(each->bytes.find(",A,Bo,0.000,no entry,,bo@x,7\r\n"), std::string::npos) << each->bytes;
  const auto moodle = grades(overview(state), people, "", "", GradesLayout::moodle);
  ASSERT_TRUE(moodle) << moodle.error().what;
  EXPECT_EQ(moodle->bytes, "Email address,ID number,spring\r\ncy@x,,\r\nada@x,,\r\nbo@x,,\r\n")
      << "no leg is no score";
  const auto gradescope = grades(overview(state), people, "", "", GradesLayout::gradescope);
  ASSERT_TRUE(gradescope) << gradescope.error().what;
  EXPECT_NE(gradescope->bytes.find("\r\nBo,bo@x,,,100\r\n"), std::string::npos)
      << gradescope->bytes;
  people["alpha"].more[0].second = "ada@x";
  EXPECT_FALSE(grades(overview(state), people, "", "", GradesLayout::moodle))
      << "whose mail is it?";
  people["alpha"].more.clear();
  EXPECT_FALSE(grades(overview(state), people, "", "", GradesLayout::moodle));
}

}  // namespace
}  // namespace mirocup::league
