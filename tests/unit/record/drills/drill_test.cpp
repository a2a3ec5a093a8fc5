// SPDX-License-Identifier: MIT
#include "record/drills/drill.hpp"

#include "tests/support/is_ok.hpp"

#include <gtest/gtest.h>

namespace mirocup::drills {
namespace {

using Json = nlohmann::ordered_json;

Json good_drill() {
  return Json::parse(R"({
    "schema": "mirocup/drill/1", "title": "T", "teaches": "t", "version": 3, "opponent": "keeper",
    "seconds": 6,
    "situation": {"ball": {"position": [{"from": 0.1, "to": 0.3}, 0]}, "clock": 4,
                  "blue": [{}, {"pose": [{"from": -0.4, "to": 0.3}, 0, 0]}]},
    "success": [{"event": "goal", "by": 5}, {"event": "no_foul", "most": 1}],
    "score": {"time": 0.5, "foul": 0.25}})");
}

std::string error_with(const char* pointer, const Json& value) {
  Json json = good_drill();
  json[Json::json_pointer(pointer)] = value;
  return test_support::why_not(parse_drill(json.dump(), "d/my.json"));
}

// Catches a key that is lost, or read into another one.
TEST(Drill, ReadsEverything) {
  const auto drill = parse_drill(good_drill().dump(), "d/my.json");
  ASSERT_TRUE(test_support::is_ok(drill));
  EXPECT_EQ(drill->name, "my");
  EXPECT_EQ(drill->version, 3);
  EXPECT_EQ(drill->opponent, "keeper");
  EXPECT_EQ(drill->seconds, 6.0);
  EXPECT_EQ(drill->tries, 60);
  EXPECT_EQ(drill->conditions, match::conditions_of(match::ConditionsPreset::hall));
  ASSERT_EQ(drill->success.size(), 2u);
  EXPECT_EQ(drill->success[0].kind, EventKind::goal);
  EXPECT_EQ(drill->success[0].by, 5.0);
  EXPECT_EQ(drill->success[1].most, 1);
  EXPECT_EQ(drill->deductions.time, 0.5);
  EXPECT_EQ(drill->deductions.foul, 0.25);
}

// Catches ranges that the seed does not draw from, draws that overlap, and a try that is longer
// than the drill.
TEST(Drill, DrawsASituationFromTheSeed) {
  const auto drill = parse_drill(good_drill().dump(), "my.json");
  ASSERT_TRUE(drill);
  std::vector<double> balls;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const auto setup = setup_of(*drill, seed);
    ASSERT_TRUE(test_support::is_ok(setup));
    const double ball = setup->start->ball->position.x();
    const double robot = setup->start->robots[0][1].state->position.x();
    EXPECT_GE(ball, 0.1);
    EXPECT_LT(ball, 0.3);
    EXPECT_GT(std::abs(ball - robot), 0.05) << "drawn again where they would overlap";
    EXPECT_EQ(setup->rules.half_s, 10.0);
    EXPECT_EQ(setup->start->phase, referee::Phase::SECOND_HALF);
    EXPECT_EQ(setup_of(*drill, seed)->start->ball->position.x(), ball);
    balls.push_back(ball);
  }
  std::sort(balls.begin(), balls.end());
  EXPECT_EQ(std::unique(balls.begin(), balls.end()), balls.end());
  EXPECT_LT(balls.front(), 0.13);
  EXPECT_GT(balls.back(), 0.22) << "a robot in its default place takes the rest";
}

TEST(Drill, NamesFileAndKeyOfAMistake) {
  EXPECT_NE(error_with("/succes", 1).find("d/my.json: /succes: there is no such key"),
            std::string::npos);
  EXPECT_NE(error_with("/success/0/event", "win").find("/success/0/event"), std::string::npos);
  EXPECT_NE(error_with("/success/0/area", {0, 0, 1, 1}).find("/success/0/area"), std::string::npos)
      << "a goal has no area";
  EXPECT_NE(error_with("/success", Json::array()).find("/success"), std::string::npos);
  EXPECT_NE(error_with("/situation/league", "middle").find("of the drill's league"),
            std::string::npos);
  EXPECT_NE(error_with("/robots", {0}).find("/robots"), std::string::npos);
  const std::string key = error_with("/situation/blue/0/speed", 1);
  EXPECT_NE(key.find("d/my.json: /situation: /blue/0/speed"), std::string::npos) << key;
  const std::string overlap =
      error_with("/situation/blue/0", {{"pose", {{{"from", -0.4}, {"to", 0.3}}, 0, 0}}});
  EXPECT_EQ(overlap, "") << "most draws are fine";
  const std::string always = error_with(
      "/situation/yellow", Json::parse(R"([{"pose": [0.2, 0, 0]}, {"pose": [0.21, 0, 0]}])"));
  EXPECT_NE(always.find("overlap by"), std::string::npos) << always;
}

}  // namespace
}  // namespace mirocup::drills
