// SPDX-License-Identifier: MIT
#include "record/situation_json.hpp"

#include "tests/support/is_ok.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace mirocup::record {
namespace {

using nlohmann::ordered_json;

ordered_json good_situation() {
  return ordered_json::parse(R"({
    "schema": "mirocup/situation/1", "league": "small", "left": "yellow",
    "ball": {"position": [0.2, 0.1], "velocity": [1, 0]},
    "blue": [{"pose": [0.7, 0, 1.5], "twist": [0.45, 0, 2]}, null, {"broken": true}],
    "yellow": [{}, {"pose": [-0.3, 0.2, [0.6, 0.8]], "wheels": [3, 4]}],
    "restart": null, "phase": "SECOND_HALF", "clock": 12.5, "score": [1, 3]})");
}

std::string error_of(const ordered_json& json) {
  return test_support::why_not(parse_situation(json.dump(), "s.json"));
}

// Catches a key that is read into another one, or lost.
TEST(SituationJson, ReadsEverything) {
  const auto situation = parse_situation(good_situation().dump(), "s.json");
  ASSERT_TRUE(test_support::is_ok(situation));
  const match::Start& start = situation->start;
  EXPECT_EQ(start.left, Team::yellow);
  EXPECT_EQ(start.ball->velocity, Vec2(1.0, 0.0));
  EXPECT_EQ(start.robots[0][0].state->twist.omega, 2.0);
  EXPECT_FALSE(start.robots[0][1].state);
  EXPECT_TRUE(start.robots[0][2].is_broken);
  EXPECT_EQ(start.robots[1][1].state->heading.sin, 0.8);
  EXPECT_EQ(start.robots[1][1].wheels.right, 4.0);
  EXPECT_FALSE(start.restart);
  EXPECT_EQ(start.phase, referee::Phase::SECOND_HALF);
  EXPECT_EQ(start.clock, 12.5);
  EXPECT_EQ(start.score, (match::ByTeam<int>{1, 3}));
  // 0.45 m/s -+ 2 rad/s 0.068 m / 2, by the wheel radius of 0.0225 m
  EXPECT_NEAR(start.robots[0][0].wheels.left, 20.0 - 3.022, 1e-3);
  EXPECT_NEAR(start.robots[0][0].wheels.right, 20.0 + 3.022, 1e-3);
}

// Catches a record that starts a leg a bit elsewhere than it was played.
TEST(SituationJson, ReadsBackWhatItWritesBitForBit) {
  const auto situation = parse_situation(good_situation().dump(), "s.json");
  ASSERT_TRUE(situation);
  const ordered_json written = to_json(*situation);
  const auto again = parse_situation(written.dump(), "s.json");
  ASSERT_TRUE(test_support::is_ok(again));
  EXPECT_EQ(to_json(*again), written);
  EXPECT_EQ(again->start.robots[0][0].state->heading.cos,
            situation->start.robots[0][0].state->heading.cos);
}

// Catches a situation that no field could hold, and a message that does not say which robots.
TEST(SituationJson, NamesTheBodiesThatOverlap) {
  ordered_json json = good_situation();
  json["yellow"][1]["pose"] = {0.67, 0.0, 0.0};
  EXPECT_EQ(error_of(json).rfind("s.json: /: yellow robot 1 and blue robot 0 overlap by ", 0), 0u)
      << error_of(json);
  json = good_situation();
  json["ball"]["position"] = {-0.3, 0.2};
  EXPECT_NE(error_of(json).find("the ball and yellow robot 1 overlap"), std::string::npos);
  json["ball"]["position"] = {0.3, 0.7};
  EXPECT_NE(error_of(json).find("the ball lies outside the field"), std::string::npos);
  json = good_situation();
  json["ball"]["position"] = {0.3, 0.0};
  EXPECT_NE(error_of(json).find("in its default place"), std::string::npos) << error_of(json);
}

TEST(SituationJson, NamesTheKeyThatIsWrong) {
  const auto error_with = [](const char* pointer, const ordered_json& value) {
    ordered_json json = good_situation();
    json[ordered_json::json_pointer(pointer)] = value;
    return error_of(json);
  };
  EXPECT_NE(error_with("/goalie", 1).find("/goalie: there is no such key"), std::string::npos);
  EXPECT_NE(error_with("/blue/0/speed", 1).find("/blue/0/speed"), std::string::npos);
  EXPECT_NE(error_with("/blue/2/twist", {1, 0, 0}).find("needs a pose"), std::string::npos);
  EXPECT_NE(error_with("/blue/3", ordered_json::object()).find("/blue"), std::string::npos);
  EXPECT_NE(error_with("/phase", "SHOOT_OUT").find("PENALTY_KICK"), std::string::npos);
  EXPECT_NE(error_with("/restart", {{"kind", "KICK_OFF"}}).find("everything stands"),
            std::string::npos);
  EXPECT_NE(error_with("/restart", {{"kind", "none"}}).find("play is on"), std::string::npos);
  EXPECT_NE(error_with("/blue/0/pose", {0.5, 0.0, 90}).find("/blue/0/pose/2: a heading is in rad"),
            std::string::npos);
  EXPECT_EQ(error_with("/blue/0/pose/2", 6.5), "") << "a replay page saves such headings";
  EXPECT_NE(error_with("/clock", -1).find("/clock"), std::string::npos);
}

// A quarter that is not given is that of the ball.
TEST(SituationJson, ReadsRestarts) {
  const auto situation = parse_situation(
      R"({"schema": "mirocup/situation/1", "ball": {"position": [-0.375, 0.4]},
          "restart": {"kind": "FREE_BALL", "taker": "yellow"}})",
      "s.json");
  ASSERT_TRUE(test_support::is_ok(situation));
  EXPECT_EQ(situation->start.restart->kind, referee::Restart::FREE_BALL);
  EXPECT_EQ(situation->start.restart->quarter.x, -1.0);
  EXPECT_EQ(situation->start.restart->quarter.y, 1.0);
}

}  // namespace
}  // namespace mirocup::record
