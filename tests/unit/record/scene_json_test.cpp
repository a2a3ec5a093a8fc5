// SPDX-License-Identifier: MIT
#include "record/scene_json.hpp"

#include "tests/support/is_ok.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace mirocup::record {
namespace {

using nlohmann::ordered_json;

ordered_json good() {
  return ordered_json::parse(R"({
    "schema": "mirocup/scene/1", "league": "middle", "duration": 0.5, "walls": true,
    "parameters": {"grip": "infinite", "k": 0.01, "rolling_friction": "per_axis",
                   "restitution": {"ball_wall": 1}, "contact_friction": {"robot_robot": 0.3},
                   "shape": [[0.03, -0.03], [0.03, 0.03], [-0.03, 0.03], [-0.03, -0.03]]},
    "ball": {"position": [0.2, 0.1], "velocity": [1, 0]},
    "robots": [{"name": "a", "pose": [0, 0, 1.5], "twist": [0.1, 0, 2],
                "wheels": [[0, 1, 2], [0.1, 3, 4]]},
               {"pose": [0.5, 0, 0], "wheels": null}],
    "sample_at": [0.3, 0.1]})");
}

TEST(SceneJson, ReadsEverything) {
  const auto scene = parse_scene(good().dump(), "s.json");
  ASSERT_TRUE(test_support::is_ok(scene));
  EXPECT_EQ(scene->league, League::middle);
  EXPECT_EQ(scene->parameters.grip, simulator::infinite_grip);
  EXPECT_EQ(scene->parameters.rolling_friction, simulator::RollingFriction::per_axis);
  EXPECT_EQ(scene->parameters.k, 0.01);
  EXPECT_EQ(scene->parameters.restitution.ball_wall, 1.0);
  EXPECT_EQ(scene->parameters.restitution.ball_robot, 0.6);
  EXPECT_EQ(scene->parameters.contact_friction.robot_robot, 0.3);
  EXPECT_EQ(scene->parameters.robot_corners.corners, 4);
  EXPECT_EQ(scene->robots[0].wheels[1].speeds.right, 4.0);
  EXPECT_EQ(scene->robots[0].state.twist.omega, 2.0);
  EXPECT_EQ(scene->robots[1].name, "robot2");
  EXPECT_FALSE(scene->robots[1].wheels_on_ground);
  EXPECT_EQ(scene->sample_at, (std::vector<double>{0.1, 0.3}));
}

// The vector is neither normalized nor turned into an angle and back.
TEST(SceneJson, TakesAHeadingAsAUnitVectorBitForBit) {
  constexpr double cosine = -0x1.6a96aea0e5e78p-1;
  constexpr double sine = 0x1.697ce75b17af6p-1;
  ordered_json json = good();
  json["robots"][0]["pose"][2] = {cosine, sine};
  const auto scene = parse_scene(json.dump(), "s.json");
  ASSERT_TRUE(test_support::is_ok(scene));
  EXPECT_EQ(scene->robots[0].state.heading.cos, cosine);
  EXPECT_EQ(scene->robots[0].state.heading.sin, sine);
}

TEST(SceneJson, WritesNumbersThatReadBackTheSame) {
  const auto scene = parse_scene(good().dump(), "s.json");
  const auto result =
      simulator::run_scene(*scene, simulator::tolerances_of(simulator::Accuracy::standard));
  const auto json = ordered_json::parse(to_json(*scene, result, 0.5).dump());
  EXPECT_EQ(json["schema"], "mirocup/scene-result/1");
  ASSERT_EQ(json["samples"].size(), 4u);
  const auto& last = json["samples"].back();
  EXPECT_EQ(last["t"], 0.5);
  EXPECT_EQ(last["robots"][0]["name"], "a");
  EXPECT_EQ(last["robots"][0]["pose"][0].get<double>(),
            result.samples.back().robots[0].position.x());
  EXPECT_EQ(last["ball"]["velocity"][0].get<double>(), result.samples.back().ball->velocity.x());
  EXPECT_EQ(json["statistics"]["impacts"], json["impacts"].size());
  EXPECT_EQ(json["statistics"]["cpu_seconds"], 0.5);
}

struct Mistake {
  const char* pointer;  // where it is made
  const char* value;
  const char* named;  // the pointer and the start of the reason that must be named
};

class SceneMistakes : public testing::TestWithParam<Mistake> {};

TEST_P(SceneMistakes, AreNamedWithFilePointerAndReason) {
  ordered_json json = good();
  json[ordered_json::json_pointer(GetParam().pointer)] = ordered_json::parse(GetParam().value);
  const auto scene = parse_scene(json.dump(), "s.json");
  ASSERT_FALSE(scene);
  EXPECT_EQ(scene.error().code, Errc::input);
  EXPECT_EQ(scene.error().what.find(std::string("s.json: ") + GetParam().named), 0u)
      << scene.error().what;
}

INSTANTIATE_TEST_SUITE_P(
    All, SceneMistakes,
    testing::Values(
        Mistake{"/schema", "\"mirocup/scene/2\"", "/schema: \"mirocup/scene/1\""},
        Mistake{"/surprise", "1", "/surprise: there is no such key"},
        Mistake{"/parameters/mass", "1", "/parameters/mass: there is no such key"},
        Mistake{"/robots/0/colour", "1", "/robots/0/colour: there is no such key"},
        Mistake{"/league", "\"huge\"", "/league: one of small, middle, large"},
        Mistake{"/walls", "1", "/walls: true or false"},
        Mistake{"/duration", "-1", "/duration: -1 is not at least 0"},
        Mistake{"/duration", "\"1\"", "/duration: a number"},
        Mistake{"/duration", "1e9", "/duration: 1e+09 is not at most 3600"},
        Mistake{"/ball/velocity", "[1e18, 0]", "/ball/velocity/0: 1e+18 is not at most 1e+06"},
        Mistake{"/parameters/robot_mass", "1e-300", "/parameters/robot_mass: 1e-300 is not"},
        Mistake{"/parameters/grip", "0", "/parameters/grip: 0 is not at least 1e-06"},
        Mistake{"/parameters/grip", "1e-9", "/parameters/grip: 1e-09 is not at least 1e-06"},
        Mistake{"/parameters/grip", "\"none\"", "/parameters/grip: a number or \"infinite\""},
        Mistake{"/parameters/robot_mass", "0", "/parameters/robot_mass: a number above 0"},
        Mistake{"/parameters/restitution/ball_wall", "1.1",
                "/parameters/restitution/ball_wall: 1.1"},
        Mistake{"/parameters/rolling_friction", "\"no\"", "/parameters/rolling_friction: one of"},
        Mistake{"/parameters/shape", "[[0,0],[1,0],[0,1]]", "/parameters/shape: the centre"},
        Mistake{"/parameters/shape", "[[1,-1],[0,0.1],[-1,-1],[0,1]]",
                "/parameters/shape: the corners"},
        Mistake{"/parameters/shape", "[[1,0],[0,1]]", "/parameters/shape: 3 to 8 values"},
        Mistake{"/ball/position", "[0]", "/ball/position: 2 values"},
        Mistake{"/ball/position", "[5, 0]", "/ball/position: ball lies outside"},
        Mistake{"/ball/position", "[0.02, 0]", "/ball/position: ball and a overlap"},
        Mistake{"/robots/0/pose", "[0, 0]", "/robots/0/pose: 3 values"},
        Mistake{"/robots/0/pose/2", "[1, 2e-6]",
                "/robots/0/pose/2: a heading [cos, sin] must be of length 1 within 1e-12"},
        Mistake{"/robots/0/pose/2", "[1, 0, 0]", "/robots/0/pose/2: 2 values"},
        Mistake{"/robots/0/wheels/0", "[0, 1]", "/robots/0/wheels/0: 3 values"},
        Mistake{"/robots/0/wheels/1/0", "-0.1", "/robots/0/wheels/1/0: -0.1"},
        Mistake{"/robots/1/name", "\"a\"", "/robots/1/name: \"a\" is taken"},
        Mistake{"/robots/1/name", "\"ball\"", "/robots/1/name: \"ball\" is taken"},
        Mistake{"/sample_at/0", "0.6", "/sample_at/0: 0.6 is not at most 0.5"}));

TEST(SceneJson, NamesMissingKeysAndTextThatIsNotJson) {
  ordered_json json = good();
  json["robots"][0].erase("pose");
  EXPECT_EQ(parse_scene(json.dump(), "s").error().what, "s: /robots/0/pose: missing");
  EXPECT_NE(parse_scene("{\"a\":", "s").error().what.find("s: /: not JSON: "), std::string::npos);
  EXPECT_NE(parse_scene("{\"a\": 1e999}", "s").error().what.find("too large"), std::string::npos);
  EXPECT_FALSE(parse_scene("[]", "s"));
}

// Catches a result that takes all memory.
TEST(SceneJson, BoundsTheStatesOfAllSamples) {
  ordered_json json = good();
  json["sample_at"] = ordered_json::array();
  for (int i = 0; i < 90'000; ++i) json["sample_at"].push_back(0.25);
  const auto scene = parse_scene(json.dump(), "s.json");
  ASSERT_FALSE(scene);
  EXPECT_EQ(scene.error().what, "s.json: /sample_at: 0 to 83333 values are expected, not 90000");
}

}  // namespace
}  // namespace mirocup::record
