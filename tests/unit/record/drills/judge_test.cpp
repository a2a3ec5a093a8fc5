// SPDX-License-Identifier: MIT
//
// Tries of drills with teams in this process. Catches an event that is not seen, one that is seen
// where there was none, and marks that are not those of the events.
#include "record/drills/judge.hpp"

#include "tests/support/controllers.hpp"
#include "tests/support/is_ok.hpp"

#include <gtest/gtest.h>

namespace mirocup::drills {
namespace {

using namespace test_support;

// Robot 1 of the tested team is on the line y = 0 and faces the ball at (0.2, 0). No keeper stands
// in the goal.
std::string drill_text(const std::string& success, const std::string& more = "") {
  return R"({"schema": "mirocup/drill/1", "title": "T", "opponent": "idle", "seconds": 3,
             "conditions": "exact",
             "situation": {"ball": {"position": [0.2, 0]},
                           "blue": [{"pose": [-0.7, 0, 1.57]}, {"pose": [0, 0, 0]},
                                    {"pose": [0.1, 0.2, 0]}],
                           "yellow": [{"pose": [0.1, -0.5, 0]}, {"pose": [-0.1, -0.5, 0]},
                                      {"pose": [0.3, -0.5, 0]}]},
             "success": )" +
         success + more + "}";
}

TryResult try_with(const std::string& text, Scripted tested_team) {
  const auto drill = parse_drill(text, "d.json");
  EXPECT_TRUE(test_support::is_ok(drill));
  Scripted opponent = idle_team();
  match::Leg leg(*setup_of(*drill, 1));
  Judge judge(*drill, leg);
  do {
    leg.advance(tested_team, opponent);
  } while (judge.follow());
  return judge.result();
}

// Robot 1 drives ahead.
Scripted shooter(double speed = 40.0) {
  return Scripted([speed](const match::Observation&) -> match::Answer {
    match::Command command;
    command.wheels[1] = {speed, speed};
    return command;
  });
}

TEST(Judge, SeesAGoalAndWhenItFell) {
  const TryResult result = try_with(drill_text(R"([{"event": "goal"}])"), shooter());
  EXPECT_TRUE(result.passed);
  EXPECT_EQ(result.marks, 1.0);
  EXPECT_GT(result.seconds, 0.5);
  EXPECT_LT(result.seconds, 1.5) << "the try is over with the goal";
  const TryResult timed =
      try_with(drill_text(R"([{"event": "goal"}])", R"(, "score": {"time": 0.6})"), shooter());
  EXPECT_NEAR(timed.marks, 1.0 - 0.6 * timed.seconds / 3.0, 1e-9);
  const TryResult missed = try_with(drill_text(R"([{"event": "goal", "by": 0.4}])"), shooter());
  EXPECT_FALSE(missed.passed);
  EXPECT_EQ(missed.why, "goal");
  EXPECT_LT(missed.seconds, 0.5) << "nothing more can come";
}

TEST(Judge, TeamsThatDoNothingGetNothing) {
  const std::string wanted = R"([{"event": "touch"}, {"event": "no_goal"}, {"event": "no_foul"}])";
  EXPECT_EQ(try_with(drill_text(wanted), idle_team()).marks, 0.0)
      << "what shall not happen has no marks beside what has to";
  EXPECT_EQ(try_with(drill_text(R"([{"event": "no_goal"}])"), idle_team()).marks, 1.0);
}

TEST(Judge, GivesMarksForEachEvent) {
  const TryResult result = try_with(
      drill_text(R"([{"event": "touch", "robot": 1, "marks": 1}, {"event": "pass", "marks": 3}])"),
      shooter());
  EXPECT_FALSE(result.passed);
  EXPECT_EQ(result.marks, 0.25);
  EXPECT_EQ(result.why, "pass");
  EXPECT_EQ(try_with(drill_text(R"([{"event": "touch", "robot": 2}])"), shooter()).marks, 0.0);
}

TEST(Judge, SeesPlacesOfRobotsAndBall) {
  const auto marks = [](const std::string& event) {
    return try_with(drill_text("[" + event + "]"), shooter(20.0)).marks;
  };
  EXPECT_EQ(marks(R"({"event": "in_area", "area": [0.3, -0.1, 0.5, 0.1]})"), 1.0);
  EXPECT_EQ(marks(R"({"event": "in_area", "area": [0.3, 0.1, 0.5, 0.2]})"), 0.0);
  EXPECT_EQ(marks(R"({"event": "in_area", "robot": 1, "area": [0.05, -0.1, 0.1, 0.1]})"), 1.0);
  EXPECT_EQ(marks(R"({"event": "in_area", "robot": 1, "area": [0.05, -0.1, 0.1, 0.1], "for": 1})"),
            0.0)
      << "it drives through";
  EXPECT_EQ(
      marks(R"({"event": "in_area", "robot": 0, "area": [-0.75, -0.1, -0.6, 0.1], "for": 1})"),
      1.0);
  EXPECT_EQ(marks(R"({"event": "pose", "robot": 0, "pose": [-0.7, 0, -1.57]})"), 1.0)
      << "front and back are alike";
  EXPECT_EQ(marks(R"({"event": "pose", "robot": 0, "pose": [-0.7, 0, 0]})"), 0.0);
  EXPECT_EQ(marks(R"({"event": "pose", "robot": 0, "pose": [-0.69, 0, 1.57]})"), 0.0);
  EXPECT_EQ(marks(R"({"event": "pose", "of": "ball", "pose": [-0.1, 0, 0], "within": 0.02})"), 1.0)
      << "behind the ball, on the way to the goal";
  EXPECT_EQ(marks(R"({"event": "pose", "of": "ball", "pose": [0.1, 0, 0], "within": 0.02})"), 0.0);
}

// Robot 1 pushes the ball to robot 2, which stands on its way.
TEST(Judge, SeesAPassAndASave) {
  const std::string pass =
      R"({"schema": "mirocup/drill/1", "title": "T", "opponent": "idle", "seconds": 3,
    "conditions": "exact", "success": [{"event": "pass"}],
    "situation": {"ball": {"position": [-0.2, 0.1]},
                  "blue": [{}, {"pose": [-0.3, 0.1, 0], "twist": [0.9, 0, 0]},
                           {"pose": [0.25, 0.1, 0]}],
                  "yellow": [{}, {"pose": [0.3, -0.4, 0]}, {"pose": [0.4, -0.4, 0]}]}})";
  Scripted passer([](const match::Observation& o) -> match::Answer {
    match::Command command;
    if (o.time < 0.15) command.wheels[1] = {40.0, 40.0};
    return command;
  });
  EXPECT_TRUE(try_with(pass, passer).passed);
  const std::string save =
      R"({"schema": "mirocup/drill/1", "title": "T", "opponent": "idle", "seconds": 2,
    "conditions": "exact", "success": [{"event": "save"}],
    "situation": {"ball": {"position": [-0.2, Y], "velocity": [-1.5, 0]},
                  "blue": [{"pose": [-0.7, Y, 1.57]}], "yellow": []}})";
  const auto with_y = [&save](const std::string& y) {
    std::string text = save;
    while (text.find('Y') != std::string::npos) text.replace(text.find('Y'), 1, y);
    return text;
  };
  EXPECT_TRUE(try_with(with_y("0.05"), idle_team()).passed);
  EXPECT_FALSE(try_with(with_y("0.3"), idle_team()).passed) << "it would have missed the goal";
}

}  // namespace
}  // namespace mirocup::drills
