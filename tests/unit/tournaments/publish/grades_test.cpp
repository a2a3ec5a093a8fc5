// SPDX-License-Identifier: MIT
#include "tournaments/publish/grades.hpp"

#include "tests/unit/tournaments/small_league.hpp"

#include <gtest/gtest.h>

namespace mirocup::league {
namespace {

// An overview points into its state, which a test therefore keeps.
LeagueState league_of_two() {
  LeagueFile file = league_file_of({"alpha", "be,ta"});
  file.title = "spring";
  file.teams[1].source = "x.so";
  return started_league(file);
}

// Returns the file, or why there is none.
std::string csv(const LeagueState& state, const PeopleOfTeams& people = {},
                const std::string& drills = "", GradesLayout layout = GradesLayout::teams,
                const MarksOfTeams& marks = {}) {
  const std::string path = drills.empty() ? "" : "d.csv";
  const auto file = grades(overview(state), people, drills, path, layout, marks);
  return file ? file->bytes : file.error().what;
}

void expect_part(const std::string& text, const std::string& part) {
  EXPECT_NE(text.find(part), std::string::npos) << part << '\n' << text;
}

// A team wins both legs of the only fixture.
void let_win(LeagueState& state, const std::string& team, int goals) {
  const bool is_home = state.name(state.fixtures[0].fixture.home) == team;
  for (const int leg : {1, 2}) {
    league::apply(state, Ruled{.fixture = "r1-f1",
                               .leg = leg,
                               .score = is_home ? HomeAway{goals, 0} : HomeAway{0, goals},
                               .signature = {"w"}});
  }
}

// Catches marks that are given to another team, and a name with a comma that is cut.
TEST(Grades, JoinTheTableWithTheMarksByName) {
  const std::string text = csv(league_of_two(), {},
                               "team,drill,score,low,high,tries,failed_seeds\n"
                               "\"be,ta\",corner,12.5,1,2,60,\n\"be,ta\",all,20.0,,,60,\n"
                               "alpha,all,70.0,,,60,1 2\n");
  EXPECT_EQ(text.rfind("rank,team,points,played,strength,strength_low,strength_high,house_beaten,"
                       "display,members,points_per_leg,state,entry,corner,all\r\n",
                       0),
            0u)
      << text;
  expect_part(text, ",12.5,20.0\r\n");
  expect_part(text, "\"be,ta\",");
  expect_part(text, ",,70.0\r\n");  // no mark, no number
}

// Outputs of several drills in one file have several lines of titles, and an "all" each.
TEST(Grades, JoinTheOutputsOfSeveralDrills) {
  const std::string first =
      "team,drill,score\nalpha,x,10.0\nalpha,all,10.0\n\"be,ta\",x,1.0\n\"be,ta\",all,1.0\n";
  const std::string text =
      csv(league_of_two(), {}, first + "team,drill,score\nalpha,y,21.0\nalpha,all,21.0\n");
  expect_part(text, ",entry,x,y,all\r\n");
  expect_part(text, ",10.0,21.0,15.5\r\n");
  expect_part(text, ",1.0,,\r\n");  // a drill is missing
  EXPECT_EQ(csv(league_of_two(), {}, first + first),
            "d.csv: line 7: alpha has a score in x already");
  // Sheets have a line for each team, and no "all".
  const std::string sheets =
      "team,sheet,score,low\nalpha,x,50.0,1\nteam,sheet,score,low\nalpha,y,21.0,";
  expect_part(csv(league_of_two(), {}, sheets), ",50.0,21.0,35.5\r\n");
}

// Catches a list that names the beaten for the winner, or a team that is no house team; and members
// that are lost.
TEST(Grades, NameTheHouseTeamsThatWereBeaten) {
  LeagueState state = league_of_two();
  let_win(state, "be,ta", 2);
  const std::string text = csv(state, {{"be,ta", {.display = "Löwen", .members = {"Ada", "Bo"}}}});
  expect_part(text, ",alpha,Löwen,Ada; Bo,");
  expect_part(text, "2,alpha,0,2,");
  expect_part(text, ",,,,0.000,no entry,\r\n");  // alpha has beaten nobody
}

TEST(Grades, RefuseAFileOfAnotherKind) {
  const LeagueState state = league_of_two();
  EXPECT_EQ(grades(overview(state), {}, "", "")->name, "grades.csv");
  EXPECT_FALSE(grades(overview(state), {}, "name;mark\nalpha;1\n", "d.csv"));
  EXPECT_FALSE(grades(overview(state), {}, "team,drill,score,low\nalpha\n", "d.csv"));
  expect_part(csv(state, {}, "team,drill,score,low\ngamma,all,50.0,1\n"),
              "d.csv: it has no team of this league");
}

// The exam office wants a row for each team of the class list, whatever became of it.
TEST(Grades, HaveARowForEachTeam) {
  LeagueState state = league_of_two();
  let_win(state, "alpha", 2);
  league::apply(state, Withdrawn{.team = "alpha", .signature = {"left"}});
  const std::string text = csv(state, {{"late", {.display = "=1+2", .members = {}}}});
  expect_part(text, "\r\n1,\"be,ta\",0,2,");
  expect_part(text, "\r\n2,alpha,6,2,");  // the withdrawn come last
  expect_part(text, ",3.000,withdrawn,");
  expect_part(text, "\r\n,late,0,0,,,,,'=1+2,,0.000,not in the league,\r\n");
}

// Catches a mark in the row of another team, and per cent of points where the staff has a scale.
TEST(Grades, HaveAMarkIfThereIsAScale) {
  const LeagueState state = league_of_two();
  PeopleOfTeams people;
  people["alpha"] = {.display = "A", .members = {"Ada"}, .more = {{"mail", "ada@x"}}};
  people["be,ta"] = {.display = "B", .members = {"Bo"}, .more = {{"mail", "bo@x"}}};
  const MarksOfTeams marks{ScaleMark{1.7, 2.1, 1.3, true, 8}, std::nullopt};
  const std::string text = csv(state, people, "", GradesLayout::teams, marks);
  expect_part(text, ",mark_high,mark_decided,mark_legs\r\n");
  expect_part(text, ",ada@x,1.70,2.10,1.30,yes,8\r\n");
  expect_part(text, ",bo@x,,,,,\r\n");
  expect_part(csv(state, people, "", GradesLayout::moodle, marks), "ada@x,,1.70\r\n");
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
  expect_part(csv(state, people, "", GradesLayout::members), ",A,Bo,0.000,no entry,,bo@x,7\r\n");
  EXPECT_EQ(csv(state, people, "", GradesLayout::moodle),
            "Email address,ID number,spring\r\ncy@x,,\r\nada@x,,\r\nbo@x,,\r\n")
      << "no leg is no score";
  expect_part(csv(state, people, "", GradesLayout::gradescope), "\r\nBo,bo@x,,,100\r\n");
  const std::string sheet = "team,sheet,score\nalpha,driving,61.5\n";
  EXPECT_EQ(csv(state, people, sheet, GradesLayout::gradescope),
            "Name,Email,SID,Total Score,Max Points\r\nCy,cy@x,,,100\r\n"
            "Ada,ada@x,,61.5,100\r\nBo,bo@x,,61.5,100\r\n");
  expect_part(csv(state, people, sheet, GradesLayout::moodle), "\r\nbo@x,,61.5\r\n");
  people["alpha"].more[0].second = "ada@x";
  EXPECT_FALSE(grades(overview(state), people, "", "", GradesLayout::moodle))
      << "whose mail is it?";
  people["alpha"].more.clear();
  EXPECT_FALSE(grades(overview(state), people, "", "", GradesLayout::moodle));
}

}  // namespace
}  // namespace mirocup::league
